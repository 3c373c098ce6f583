// SPDX-License-Identifier: Apache-2.0
// Pictures by Phong shading in the kernels against the reference, within their bound.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "model/pipeline/engine.hpp"
#include "model/shade/frame_lighting.hpp"
#include "ref/geometry/surface.hpp"
#include "ref/raster/architecture.hpp"
#include "ref/scene/scene.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "tests/config_path.hpp"
#include "tests/shade/lit_configs.hpp"

namespace halfspace::tests {
namespace {

struct SceneResult {
  std::uint64_t pixels = 0, differ = 0, jumps = 0;
  double largest = 0, share = 0, bound = 0, shortest = 2;
};

// A scene in the kernels, against the exact formula with its bound, and against the reference's picture.
SceneResult compare_scene(const std::string& name, bool polished, const Config& config, int width, int height,
                          int within) {
  ref::Scene scene = ref::load_scene(name);
  if (polished) {
    for (ref::Material& material : scene.materials) material.specular = {0.9, 0.7, 1}, material.shininess = 14;
    for (const glm::dvec3& way : {glm::dvec3(-1, -1, -1), {1, -2, 0}, {0.3, 0.2, -1}, {-1, 0, 0.5}}) {
      if (int(scene.lights.size()) == config.lights) break;
      scene.lights.push_back({});
      scene.lights.back().direction = glm::normalize(way);
      scene.lights.back().colour = {0.15, 0.2, 0.17};
    }
  }
  const model::Configuration configuration = configuration_of(config);
  ref::Geometry geometry(scene, {width, height, config.range_bits, config.subpixel_bits});
  const ref::SnappedList list = ref::snap(geometry.positions(), model::raster_format(configuration));
  const auto engine = model::make_engine(configuration, 4);
  engine->light(model::frame_lighting(geometry, config));
  const ref::Frame got = engine->render(list);
  const auto surface = ref::lit_surface(geometry, list, ref::ShadingMode::kPhong);
  const ref::Drawing want = ref::draw(list, *surface, ref::Architecture::kDelta);
  const ref::DistantScene distant = ref::distant_scene(scene, geometry.viewpoint(), model::most_squarings(config));

  SceneResult result;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t at = std::size_t(y) * width + x;
      const std::uint32_t k = got.index[at];
      if (k == 0 || k != want.triangle[at]) continue;
      ++result.pixels;
      const ref::SnappedTriangle& triangle = list.triangles[k - 1];
      const glm::dvec3 n =
          ref::normal_at(ref::OrderedTriangle(triangle), geometry.normals(k - 1), config.subpixel_bits, x, y);
      const int material = distant.triangles[distant.of_face[geometry.positions().face[k - 1] - 1]].material;
      const glm::dvec3 exact = ref::distant_colour(distant.materials[std::size_t(material)], distant.lights, n);
      double distance = 0;
      for (int v = 0; v < 3; ++v) {
        distance = std::max(distance, std::ldexp(std::abs(double(triangle.x[v])) + std::abs(double(triangle.y[v])),
                                                 -config.subpixel_bits) +
                                          x + y + 1);
      }
      result.shortest = std::min(result.shortest, glm::length(n));
      for (int c = 0; c < 3; ++c) {
        const model::PhongBound bound = model::phong_bound(distant, material, n, c, distance, config);
        const double error = std::abs(double(got.colour[at][c]) - exact[c]), most = 0.5 + bound.error + bound.jump;
        EXPECT_LE(error, most) << name << ", pixel " << x << ", " << y << ", channel " << c;
        EXPECT_LE(std::abs(int(got.colour[at][c]) - int(want.colour[at][c])), within)
            << name << ", pixel " << x << ", " << y << ", channel " << c << ", bound " << bound.error << " and "
            << bound.jump;
        result.differ += got.colour[at][c] != want.colour[at][c];
        result.jumps += bound.jump > 0;
        result.largest = std::max(result.largest, error - 0.5);
        result.bound = std::max(result.bound, bound.error);
        if (bound.jump == 0) result.share = std::max(result.share, (error - 0.5) / bound.error);
      }
      if (testing::Test::HasFailure()) return result;
    }
  }
  std::printf(
      "%-10s %-9s %8llu pixels: %.3f LSB beyond the rounding (bound %.3f; %.2f of a pixel's), %llu channels differ, "
      "%llu at a jump, shortest normal %.3f\n",
      config.name, name.c_str(), static_cast<unsigned long long>(result.pixels), result.largest, result.bound,
      result.share, static_cast<unsigned long long>(result.differ), static_cast<unsigned long long>(result.jumps),
      result.shortest);
  EXPECT_GT(result.pixels, 1000u) << name;
  return result;
}

TEST(PhongScenes, AreWithinOneOfTheReferenceInHigh) {
  for (const std::string& name : ref::builtin_scene_names())
    compare_scene(name, false, PhongHigh::config(), 640, 480, 1);
}
TEST(PhongScenes, AndPolishedUnderFourLights) {
  for (const std::string& name : ref::builtin_scene_names())
    compare_scene(name, true, PhongHigh::config(), 640, 480, 1);
}
TEST(PhongScenes, KeepTheirBoundInLow) { compare_scene("teapot", false, PhongLow::config(), 320, 200, 255); }

TEST(PhongScenes, AreWithinOneOfTheReferenceInMiddle) {
  for (const std::string& name : ref::builtin_scene_names())
    compare_scene(name, false, PhongMiddle::config(), 640, 480, 1);
}

}  // namespace
}  // namespace halfspace::tests
