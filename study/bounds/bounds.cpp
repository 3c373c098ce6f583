// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/bounds/bounds_measure.hpp"
#include "study/bounds/lighting_measure.hpp"
#include "study/proofs/bounds_proved.hpp"
#include "study/proofs/lighting_bounds.hpp"

namespace halfspace::model {

bool BoundRow::see(double error, double bound) {
  ++compared;
  error = std::fabs(error);
  if (error > bound) ++exceeded;
  if (error <= seen) return false;
  seen = error;
  return true;
}

bool BoundRow::count(std::uint64_t values, std::uint64_t differ) {
  compared += values;
  exceeded += differ;
  seen += double(differ);
  return differ != 0 && where.number == 0;
}

bool BoundsReport::holds() const {
  for (const BoundRow& row : rows) {
    if (row.present() && (row.compared == 0 || row.exceeded != 0)) return false;
  }
  return true;
}

BoundsReport proved_bounds(const Config& config) {
  BoundsReport report;
  report.rows.resize(kQuantities);
  auto exact = [&](Quantity q, const char* kernel, const char* quantity) {
    report.rows[q] = {kernel, quantity, "", "", 0};
  };
  auto bound = [&](Quantity q, const char* kernel, const char* quantity, const std::string& unit, const char* proof,
                   double proved) {
    report.rows[q] = {kernel, quantity, unit, proof, proved};
  };
  auto place = [](int fraction) { return fmt::format("2^-{}", fraction); };
  auto reached = [&](const PlaneNumbers& n, Vertices v) { return plane_bound(n, largest_reach(config, v)); };

  bound(kSnap, "snap", "position", place(config.subpixel_bits) + " px", "snap", 0.5);
  exact(kEdges, "triangle_setup", "edge functions");
  if (has_planes(config)) {
    bound(kReciprocal, "triangle_setup", "reciprocal, relative", place(config.reciprocal_bits),
          "triangle_setup_reciprocal", 1);
  }
  exact(kCoverage, "raster_pineda", "coverage");
  exact(kZtest, tests_planes(config) ? "ztest_plane" : "ztest_index",
        has_depth(config) ? "index and depth kept" : "index kept");
  exact(kScan, "scan_index", "index");
  if (!is_phong(config))
    exact(kColourSteps, "shade_gouraud", is_gouraud(config) ? "colour, from its plane" : "colour, from the triangle");
  if (has_depth(config)) {
    const PlaneNumbers depth = depth_numbers(config);
    const PlaneBound far = reached(depth, Vertices::kGuardBand), near = reached(depth, Vertices::kFrame);
    bound(kDepthGradient, "triangle_setup", "gradient of depth", place(depth.fraction), "triangle_setup_product", 0.5);
    bound(kDepthPlane, "triangle_setup", "depth plane", "LSB", "raster_pineda_depth", value(far.in_register));
    bound(kDepthPlaneInFrame, "triangle_setup", "… in the frame", "LSB", "raster_pineda_depth_frame",
          value(near.in_register));
    exact(kDepthSteps, "raster_pineda", "depth, from its plane");
    bound(kDepthRounded, "raster_pineda", "depth, rounded", "LSB", "raster_pineda_rounded", value(far.rounded));
  }
  if (is_gouraud(config)) {
    const PlaneNumbers colour = colour_numbers(config);
    const PlaneBound far = reached(colour, Vertices::kGuardBand), near = reached(colour, Vertices::kFrame);
    bound(kColourGradient, "shade_setup", "gradient of colour", place(colour.fraction), "shade_setup_product", 0.5);
    bound(kColourPlane, "shade_setup", "colour plane", "LSB", "shade_gouraud_colour", value(far.in_register));
    bound(kColourPlaneInFrame, "shade_setup", "… in the frame", "LSB", "shade_gouraud_colour_frame",
          value(near.in_register));
    bound(kColourRounded, "shade_gouraud", "colour, rounded", "LSB", "shade_gouraud_rounded", value(far.rounded));
  }
  if (is_phong(config)) {
    const PlaneNumbers normal = normal_numbers(config);
    const PlaneBound far = reached(normal, Vertices::kGuardBand), near = reached(normal, Vertices::kFrame);
    const std::string unit = place(config.normal_bits);
    bound(kNormalGradient, "phong_setup", "gradient of a normal", place(config.normal_bits + normal.fraction),
          "phong_setup_product", 0.5);
    bound(kNormalPlane, "phong_setup", "plane of a normal", unit, "shade_phong_normal", value(far.in_register));
    bound(kNormalPlaneInFrame, "phong_setup", "… in the frame", unit, "shade_phong_normal_frame",
          value(near.in_register));
    exact(kNormalSteps, "shade_phong", "normal, from its plane");
    bound(kNormalRounded, "shade_phong", "normal, rounded", unit, "shade_phong_rounded", value(far.rounded));
  }
  if (has_lighting(config)) {
    const char* const lighting = is_phong(config) ? "shade_phong" : "light_vertex";
    const int u = cosine_fraction(config), squarings = exact_log2(config.gloss);
    bound(kLightCosine, lighting, "cosine", place(u), "light_cosine", std::ldexp(value(cosine_bound(config)), u));
    if (squarings > 0) {
      bound(kLightPower, lighting, "largest power of a cosine", place(u), "light_power",
            std::ldexp(value(power_bound(config, squarings)), u));
    }
    bound(kLightSum, lighting, "colour of a white light", "LSB", "light_sum", value(light_bound(config)));
  }
  if (has_objects(config)) {
    exact(kEntry, "scan_object", "depth and object");
    exact(kMerge, "ztest_merge", "nearer entry");
    exact(kMergeFound, "ztest_merge", "pixels of an object");
  }
  return report;
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

BoundsReport measured_bounds(const Configuration& configuration, const MeasureOptions& options) {
  const Config config = configuration.config();
  BoundsReport report = proved_bounds(config);
  measure_snapping(config, options, report.rows[kSnap]);
  measure_frames(configuration, options.seed, report);
  if (has_objects(config)) measure_merges(configuration, options.seed, report);
  if (has_lighting(config)) measure_lighting(config, options.seed, 1 + options.triangles / 10, report);

  TriangleMeter meter(config, report);
  TriangleSource source(config, options.seed);
  // A search counts as one class; it tries many triangles and measures few.
  const std::size_t searches = has_depth(config) + is_gouraud(config);
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
    for (const bool depth : {true, false}) {
      if (depth ? !has_depth(config) : !is_gouraud(config)) continue;
      meter.search(source, vertices, depth, kTriedForOne * options.triangles);
      tell(options.triangles);
    }
    if (searches == 0) meter.measure(source.farthest(vertices));
  }
  return report;
}

}  // namespace halfspace::model
