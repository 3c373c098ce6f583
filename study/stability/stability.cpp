// SPDX-License-Identifier: Apache-2.0
#include "study/stability/stability.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "study/bounds/bounds_probe.hpp"
#include "study/proofs/bounds_proved.hpp"
#include "study/stability/plane_models.hpp"
#include "study/stability/stability_triangles.hpp"

namespace halfspace::model {

const char* plane_method_name(PlaneMethod method) {
  constexpr const char* kNames[kPlaneMethods] = {"kernels", "float32 from the origin", "float32 from a vertex",
                                                 "fixed point, gradients saturate"};
  return kNames[method];
}

namespace {

constexpr std::size_t kPixels = 300;  // of a triangle that are looked at

class Meter {
 public:
  explicit Meter(const Config& config)
      : config_(config),
        probe_(make_kernel_probe(config)),
        depth_(depth_numbers(config)),
        colour_(colour_numbers(config)) {
    probe_->set_frame(config.width, config.height);
  }

  void measure(const ref::SnappedTriangle& triangle, StabilityPoint& point) {
    const ExactTriangle exact(triangle, config_.subpixel_bits);
    const ProbedSetup setup = probe_->setup(triangle);
    std::vector<Pixel> covered;
    // Errors of planes are largest at the ends of rows; float32 rounds anew at each pixel.
    const PixelSpan rows = exact.rows(config_.height);
    for (int y = rows.first; y <= rows.last; ++y) {
      const PixelSpan span = exact.span(y, config_.width);
      if (span.first > span.last) continue;
      covered.push_back({span.first, y});
      if (span.last > span.first) covered.push_back({span.last, y});
      if (span.last > span.first + 1) covered.push_back({(span.first + span.last) / 2, y});
    }
    pixels_.clear();
    const std::size_t step = (covered.size() + kPixels - 1) / kPixels;
    for (std::size_t n = 0; n < covered.size(); n += step) pixels_.push_back(covered[n]);
    if (step > 1) pixels_.push_back(covered.back());
    ++point.triangles;
    point.pixels += pixels_.size();
    point.longest = std::max(point.longest, std::ldexp(std::sqrt(squared_length(triangle)), -config_.subpixel_bits));
    if (has_depth(config_)) measure(exact, exact.depth(), depth_, setup.depth, point.depth);
    if (is_gouraud(config_)) measure(exact, exact.colour(0), colour_, setup.colour[0], point.colour);
  }

 private:
  struct Pixel {
    int x, y;
  };

  void measure(const ExactTriangle& exact, const Values& values, const PlaneNumbers& numbers, const ProbedPlane& plane,
               PlaneErrors& errors) const {
    const int b = numbers.value_bits, g = numbers.fraction, f = config_.subpixel_bits;
    const FloatPlane in_float(exact, values, b, f);
    const SaturatedPlane saturated(exact, values, b, f, g);
    for (const Pixel& p : pixels_) {
      const Wide value = exact.value(values, p.x, p.y);
      const double truth = double(value) / double(exact.area());
      // The register holds ½ more.
      const std::uint64_t bits = plane.start - (std::uint64_t(1) << (g - 1)) +
                                 std::uint64_t(plane.dx) * std::uint64_t(p.x - plane.x) +
                                 std::uint64_t(plane.dy) * std::uint64_t(p.y - plane.y);
      see(errors, kKernelPlane, register_error(bits & ((std::uint64_t(1) << (b + g)) - 1), b, g, value, exact.area()));
      see(errors, kFloatFromOrigin, in_float.from_origin(p.x, p.y) - truth);
      see(errors, kFloatFromVertex, in_float.from_vertex(p.x, p.y) - truth);
      see(errors, kSaturatedGradients, saturated.value(p.x, p.y) - truth);
    }
  }

  static void see(PlaneErrors& errors, PlaneMethod method, double error) {
    errors.largest[method] = std::max(errors.largest[method], std::fabs(error));
    errors.beyond[method] += std::fabs(error) > 0.5;
  }

  Config config_;
  std::unique_ptr<KernelProbe> probe_;
  PlaneNumbers depth_, colour_;
  std::vector<Pixel> pixels_;
};

}  // namespace

StabilityStudy stability_study(const Config& config, const StabilityOptions& options) {
  StabilityStudy study;
  const Dyadic reach = largest_reach(config, Vertices::kGuardBand);
  if (has_depth(config)) study.depth_bound = value(plane_bound(depth_numbers(config), reach).in_register);
  if (is_gouraud(config)) study.colour_bound = value(plane_bound(colour_numbers(config), reach).in_register);

  // A quarter of a pixel, where the grid has it.
  const int smallest = std::max(-2, 1 - config.subpixel_bits);
  const int shapes = options.largest_aspect + 1 + config.range_bits - smallest + 1;
  const std::size_t total = std::size_t(shapes);
  ShapeSource source(config, options.seed);
  Meter meter(config);
  auto run = [&](int log2, bool aspect) {
    StabilityPoint point;
    point.log2 = log2;
    for (int n = 0; n < options.triangles; ++n) {
      const auto triangle = aspect ? source.of_aspect(log2) : source.of_size(log2);
      if (!triangle) break;
      meter.measure(*triangle, point);
    }
    if (options.progress) options.progress(study.aspect.size() + study.size.size() + 1, total);
    return point;
  };
  for (int log2 = 0; log2 <= options.largest_aspect; ++log2) {
    study.aspect.push_back(run(log2, true));
    if (study.aspect.back().triangles > 0) study.reachable = log2;
  }
  for (int log2 = smallest; log2 <= config.range_bits; ++log2) study.size.push_back(run(log2, false));
  return study;
}

}  // namespace halfspace::model
