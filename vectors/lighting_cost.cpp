// SPDX-License-Identifier: Apache-2.0
#include "vectors/lighting_cost.hpp"

#include <algorithm>
#include <chrono>
#include <set>

#include "ref/raster.hpp"
#include "vectors/configuration.hpp"

namespace halfspace::vectors {
namespace {

constexpr int kRuns = 5;

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

class Stopwatch {
 public:
  double ms() const { return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count(); }

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
  for (const ref::Instance& instance : scene.instances) cost.triangles.a += scene.meshes[instance.mesh].triangles.size();

  std::vector<double> positions, facing, visible;
  for (int run = 0; run < kRuns; ++run) {
    const Stopwatch transform;
    ref::Geometry all(scene, view);
    positions.push_back(transform.ms());
    const std::size_t triangles = all.positions().triangles.size();
    const Stopwatch light_all;
    for (std::size_t k = 0; k < triangles; ++k) all.colours(k);
    facing.push_back(light_all.ms());

    ref::Geometry deferred(scene, view);
    const ref::Frame frame = ref::render(ref::snap(deferred.positions(), format));
    const Stopwatch light_visible;
    for (std::size_t k = 0; k < triangles; ++k) {
      if (frame.visible[k]) deferred.colours(k);
    }
    visible.push_back(light_visible.ms());
    if (run != 0) continue;
    std::set<std::uint32_t> faces(all.positions().face.begin(), all.positions().face.end()), seen;
    for (std::size_t k = 0; k < triangles; ++k) {
      if (frame.visible[k]) seen.insert(all.positions().face[k]);
    }
    cost.triangles.b = faces.size();
    cost.triangles.c = seen.size();
    cost.corners_facing = all.lit_corners();
    cost.corners_visible = deferred.lit_corners();
  }
  cost.positions_ms = median(positions);
  cost.light_facing_ms = median(facing);
  cost.light_visible_ms = median(visible);
  return cost;
}

}  // namespace halfspace::vectors
