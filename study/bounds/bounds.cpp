// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/error.hpp"
#include "study/bounds/bounds_measure.hpp"
#include "study/bounds/lighting_measure.hpp"

namespace halfspace::model {

bool BoundRow::see(double error, double bound) {
  ++compared;
  error = std::fabs(error);
  if (!(error <= bound)) ++exceeded;
  if (error <= seen) return false;
  seen = error;
  return true;
}

bool BoundRow::hold(double error, double bound) {
  ++compared;
  if (!(std::fabs(error) > bound)) return false;
  return ++exceeded == 1 && seen <= proved;
}

bool BoundRow::count(std::uint64_t values, std::uint64_t differ) {
  compared += values;
  exceeded += differ;
  seen += double(differ);
  return differ != 0 && where.number == 0;
}

const char* plane_name(PlaneKind kind) {
  constexpr const char* kNames[] = {"depth", "colour", "normal", "coordinate", "difference"};
  return kNames[kind];
}
Quantity plane_row(PlaneKind kind) {
  constexpr Quantity kRows[] = {kDepthPlane, kColourPlane, kNormalPlane, kCoordinatePlane, kDifferencePlane};
  return kRows[kind];
}

bool BoundsReport::holds() const {
  for (const BoundRow& row : rows) {
    if (row.present() && (row.compared == 0 || row.exceeded != 0)) return false;
  }
  return true;
}

namespace {

// A triangle that a search tries has one pixel looked at; one of another class, all of them.
constexpr int kTriedForOne = 40;

// Random numbers of the range, and what rounds worst: ties.
void measure_snapping(const Config& config, const MeasureOptions& options, BoundRow& row) {
  std::mt19937_64 random(options.seed);
  const int f = config.subpixel_bits;
  for (std::uint64_t n = 1; n <= 10000; ++n) {
    const double unit = double(random() >> 11) * 0x1p-53 * 2 - 1;
    double position = std::ldexp(unit, config.range_bits - 1);
    if (n % 4 == 0) position = std::ldexp(std::floor(std::ldexp(position, f)) + 0.5, -f);
    if (row.see(ref::snapped_position(position, f) - std::ldexp(position, f), 0.5)) {
      row.where = {fmt::format("position {}", position), n};
    }
  }
}

}  // namespace

BoundsReport measured_bounds(const Configuration& asked, const MeasureOptions& options) {
  if (up_converts(asked.config())) {
    throw ref::Error(
        fmt::format("configuration {} has the units of key frames and of frames in between: measure one "
                    "without frames_between, and one of shading = \"motion\" with its numbers",
                    asked.name()));
  }
  // Culling drops triangles, and changes nothing of those that are drawn: both sides are measured.
  Config config = asked.config();
  config.cull = Cull::kNone;
  const Configuration configuration(asked.name(), config);
  BoundsReport report = proved_bounds(config);
  measure_snapping(config, options, report.rows[kSnap]);
  measure_frames(configuration, options.seed, report);
  if (has_objects(config)) measure_merges(configuration, options.seed, report);
  if (has_lighting(config)) measure_lighting(config, options.seed, 1 + options.triangles / 10, report);

  if (has_motion(config)) measure_compensation(configuration, options.seed, report);
  const auto probe = make_kernel_probe(config);
  if (has_coordinates(config) && has_perspective(config)) measure_inverse(config, *probe, report.rows[kInverse]);
  if (has_texture(config)) measure_texels(config, *probe, options.seed, report);

  TriangleMeter meter(configuration, report);
  TriangleSource source(config, options.seed);
  // A search counts as one class; it tries many triangles and measures few.
  const std::vector<PlaneChannel> channels = plane_channels(config);
  const std::size_t searches = channels.size();
  const std::size_t total = (std::size(kTriangleClasses) + 2 * searches) * options.triangles;
  std::size_t done = 0;
  auto tell = [&](std::size_t triangles) {
    done += triangles;
    if (options.progress) options.progress(done, total);
  };
  for (const TriangleClass kind : kTriangleClasses) {
    // Triangles that cover a frame are measured in a small one: an error is of a pixel, whatever is around it.
    const int largest = kind == TriangleClass::kHuge ? 48 : 8192;
    meter.begin(class_name(kind), std::min(config.width, largest), std::min(config.height, largest));
    for (int n = 0; n < options.triangles; ++n) meter.measure(source.next(kind)), tell(1);
  }
  for (const Vertices vertices : {Vertices::kFrame, Vertices::kGuardBand}) {
    meter.begin(vertices == Vertices::kFrame ? "searched, in the frame" : "searched, in the guard band", config.width,
                config.height);
    for (const PlaneChannel& channel : channels) {
      meter.search(source, vertices, channel.kind, kTriedForOne * options.triangles);
      tell(options.triangles);
    }
    if (searches == 0) meter.measure(source.farthest(vertices));
  }
  meter.finish();
  return report;
}

}  // namespace halfspace::model
