// SPDX-License-Identifier: Apache-2.0
#include "study/papers/lighting_cost.hpp"

#include <algorithm>
#include <chrono>
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

}  // namespace

LightingCost measure_lighting(const ref::Scene& scene, const std::string& config, int width, int height) {
  ref::RasterFormat format = raster_format(find_configuration(config));
  format.width = width;
  format.height = height;
  format.triangles = 1 << 22;
  const ref::View view{width, height, format.range_bits, format.subpixel_bits};
  LightingCost cost;
  for (const ref::Instance& instance : scene.instances)
    cost.triangles.a += scene.meshes[instance.mesh].triangles.size();

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
      std::set<std::uint32_t> faces;
      for (std::size_t k = 0; k < frame.visible.size(); ++k) {
        if (!deferred || frame.visible[k]) faces.insert(geometry.positions().face[k]);
      }
      (deferred ? cost.triangles.c : cost.triangles.b) = faces.size();
      (deferred ? cost.corners_visible : cost.corners_facing) = geometry.lit_corners();
    }
  }
  cost.positions_ms = median(positions);
  cost.light_facing_ms = median(facing);
  cost.light_visible_ms = median(visible);
  return cost;
}

}  // namespace halfspace::model
