// SPDX-License-Identifier: Apache-2.0
#include "study/papers/lighting_cost.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "model/formats/configuration.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::model {
namespace {

constexpr int kRuns = 5;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

class Stopwatch {
 public:
  double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Distinct faces of the scene, of the triangles that are wanted.
template <class Wanted>
std::uint64_t faces_of(const ref::TriangleList& list, Wanted wanted) {
  std::set<std::uint32_t> faces;
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    if (wanted(k)) faces.insert(list.face[k]);
  }
  return faces.size();
}

// Is the percentage what is printed, to `places` decimals?
bool prints(double part, double whole, double printed, int places) {
  const double scale = std::pow(10.0, places);
  return std::lround(100 * part / whole * scale) == std::lround(printed * scale);
}

}  // namespace

std::pair<std::uint64_t, std::uint64_t> visible_of(std::uint64_t a, std::uint64_t b, const PrintedShares& printed) {
  std::pair<std::uint64_t, std::uint64_t> range{1, 0};
  for (std::uint64_t c = 1; c <= b; ++c) {
    const TriangleCounts n{a, b, c};
    const double cost = double(dual(n).cost());
    if (!prints(double(c), double(b), printed.c_of_b, 0) || !prints(double(c), double(a), printed.c_of_a, 0) ||
        !prints(cost, double(type_1(n).cost()), printed.dual_of_type_1, 1) ||
        !prints(cost, double(type_2(n).cost()), printed.dual_of_type_2, 1))
      continue;
    if (range.first > range.second) range.first = c;
    range.second = c;
  }
  return range;
}

LightingCost measure_lighting(const ref::Scene& scene, const std::string& config, int width, int height) {
  ref::RasterFormat format = raster_format(find_configuration(config));
  format.width = width;
  format.height = height;
  format.triangles = 1 << 22;
  const ref::View view{width, height, format.range_bits, format.subpixel_bits};
  LightingCost cost;
  for (const ref::Instance& instance : scene.instances) cost.passed.a += scene.meshes[instance.mesh].triangles.size();

  std::vector<double> positions, facing, visible;
  for (int run = 0; run < kRuns; ++run) {
    for (const bool deferred : {false, true}) {
      const Stopwatch transform;
      ref::Geometry geometry(scene, view);
      positions.push_back(transform.ms());
      // In either case, so that lighting begins with the same caches.
      const ref::Frame frame = ref::render(ref::snap(geometry.positions(), format));
      const Stopwatch light;
      for (std::size_t k = 0; k < frame.visible.size(); ++k) {
        if (!deferred || frame.visible[k]) geometry.colours(k);
      }
      (deferred ? visible : facing).push_back(light.ms());
      if (deferred) {
        const std::set<std::uint32_t> shown(frame.index.begin(), frame.index.end());
        cost.passed.c = faces_of(geometry.positions(), [&](std::size_t k) { return bool(frame.visible[k]); });
        cost.seen.c = faces_of(geometry.positions(), [&](std::size_t k) { return shown.count(k + 1) != 0; });
      } else {
        cost.passed.b = faces_of(geometry.positions(), [](std::size_t) { return true; });
      }
      (deferred ? cost.corners_visible : cost.corners_facing) = geometry.lit_corners();
    }
  }
  cost.seen.a = cost.passed.a, cost.seen.b = cost.passed.b;
  cost.positions_ms = median(positions);
  cost.light_facing_ms = median(facing);
  cost.light_visible_ms = median(visible);
  return cost;
}

}  // namespace halfspace::model
