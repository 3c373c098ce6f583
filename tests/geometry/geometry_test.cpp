// SPDX-License-Identifier: Apache-2.0
// Projection, clipping and light against what they are worked out to be by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ref/geometry/viewpoint.hpp"
#include "tests/geometry/three_formats.hpp"
#include "tests/raster/random_triangles.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {
namespace {

Scene scene_of(Mesh mesh, const Camera& camera) {
  Scene scene;
  mesh.normals.assign(mesh.positions.size(), {0, 0, 1});
  scene.meshes = {std::move(mesh)};
  scene.materials.emplace_back();
  scene.materials[0].two_sided = true;
  scene.instances = {{0, glm::dmat4(1)}};
  scene.camera = camera;
  return scene;
}

TEST(Geometry, GroundThatReachesBehindTheViewerEndsAtTheHorizon) {
  Mesh ground;
  ground.positions = {{0, -1, 5000}, {60000, -1, -60000}, {-60000, -1, -60000}};
  ground.triangles = {{0, 1, 2}};
  Camera camera;
  camera.half_height = 0.5, camera.near = 0.1, camera.far = 100000;
  for (const RasterFormat& format : kAll) {
    const Frame frame = render(snap(project(scene_of(ground, camera), view_of(format)), format));
    for (int y = 0; y < format.height; ++y) {
      for (int x = 0; x < format.width; ++x) {
        if (std::abs(y + 0.5 - format.height / 2.0) < 1) continue;
        ASSERT_EQ(frame.index[std::size_t(y) * format.width + x] != 0, y > format.height / 2)
            << format.name << " " << x << ", " << y;
      }
    }
  }
}

double distance_to_line(const Vertex& a, const Vertex& b, double x, double y) {
  return std::abs((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / std::hypot(b.x - a.x, b.y - a.y);
}

// Corners made by clipping are snapped like others, which turns an edge by less than a sub-pixel; all else is
// the same.
TEST(Geometry, GuardBandDoesNotChangeTheFrame) {
  Random random(6);
  Camera camera;
  camera.orthographic = true;
  camera.half_width = 320, camera.half_height = 240, camera.near = 1, camera.far = 3;
  const View narrow = view_of(kMiddle), wide{640, 480, 14, 8};
  RasterFormat wide_format = kMiddle;
  wide_format.range_bits = 14;
  int clipped = 0;
  for (int k = 0; k < 100; ++k) {
    Mesh mesh;
    for (int v = 0; v < 3; ++v) mesh.positions.emplace_back(pick(random, -4000, 4000), pick(random, -4000, 4000), -2);
    mesh.triangles = {{0, 1, 2}};
    const Scene scene = scene_of(mesh, camera);
    const TriangleList whole = project(scene, wide), parts = project(scene, narrow);
    if (whole.triangles.empty()) continue;  // beside the frame
    clipped += parts.triangles.size() > 1;
    ASSERT_EQ(whole.triangles.size(), 1u);
    const auto& t = whole.triangles[0];
    const Frame a = render(snap(whole, wide_format)), b = render(snap(parts, kMiddle));
    for (std::size_t at = 0; at < a.index.size(); ++at) {
      if ((a.index[at] != 0) == (b.index[at] != 0)) continue;
      const std::size_t column = at % 640, row = at / 640;
      const double x = double(column) + 0.5, y = double(row) + 0.5;
      ASSERT_LT(std::min({distance_to_line(t[0], t[1], x, y), distance_to_line(t[1], t[2], x, y),
                          distance_to_line(t[2], t[0], x, y)}),
                1.0 / 128);
    }
  }
  EXPECT_GT(clipped, 20);
}

TEST(Geometry, GuardBandIsExactWhereCornersFallOnTheGrid) {
  Mesh mesh;
  mesh.positions = {{-310, 230, -2}, {3000, 230, -2}, {-310, -3080, -2}};
  mesh.triangles = {{0, 1, 2}};
  Camera camera;
  camera.orthographic = true;
  camera.half_width = 320, camera.half_height = 240, camera.near = 1, camera.far = 3;
  const TriangleList list = project(scene_of(mesh, camera), view_of(kMiddle));
  EXPECT_GT(list.triangles.size(), 1u);
  EXPECT_EQ(covered(render(snap(list, kMiddle))), std::size_t(630 * 470));
}

TEST(Geometry, MirrorsKeepTheirOutside) {
  Scene scene = load_scene("cube");
  const std::size_t faces = project(scene, view_of(kMiddle)).triangles.size();
  scene.instances[0].to_world[0] *= -1;
  EXPECT_EQ(project(scene, view_of(kMiddle)).triangles.size(), faces);
  scene.meshes[0].triangles = {{0, 2, 1}};  // the face on the left, inside out: seen
  scene.instances[0].to_world = glm::dmat4(1);
  EXPECT_EQ(project(scene, view_of(kMiddle)).triangles.size(), 1u);
  std::swap(scene.meshes[0].triangles[0][1], scene.meshes[0].triangles[0][2]);
  EXPECT_TRUE(project(scene, view_of(kMiddle)).triangles.empty());
  expect_in("its 1 triangles in the frame are seen from behind", why_unseen(scene, view_of(kMiddle)));
}

// Light, viewer and normal on one line: I = Ia Ka + Ii (Kd + Ks).
TEST(Geometry, ZoomScalesAboutTheMiddleOfTheFrame) {
  constexpr double kZoom = 0.7;  // nothing leaves the frame, nor is clipped
  const View view = view_of(kMiddle);
  for (const char* name : {"castle", "pyramid", "cube_zoom"}) {  // framed, framed, with a camera
    Scene scene = load_scene(name, 0.2);
    const TriangleList before = project(scene, view);
    zoom(scene, kZoom, double(view.width) / view.height);
    const TriangleList after = project(scene, view);
    ASSERT_EQ(after.triangles.size(), before.triangles.size()) << name;
    for (std::size_t k = 0; k < before.triangles.size(); ++k) {
      for (int v = 0; v < 3; ++v) {
        const Vertex &a = before.triangles[k][v], &b = after.triangles[k][v];
        ASSERT_NEAR(b.x - view.width / 2.0, kZoom * (a.x - view.width / 2.0), 1e-8) << name;
        ASSERT_NEAR(b.y - view.height / 2.0, kZoom * (a.y - view.height / 2.0), 1e-8) << name;
        ASSERT_NEAR(b.z, a.z, 1e-12) << name;
      }
    }
  }
}

TEST(Geometry, LightingIsPhongs) {
  Mesh mesh;
  mesh.positions = {{0, 0, -2}, {1e-3, 0, -2}, {0, 1e-3, -2}};
  mesh.colours.assign(3, {1, 0.5, 1});
  mesh.triangles = {{0, 1, 2}};
  Camera camera;
  camera.half_height = 0.001;
  Scene scene = scene_of(mesh, camera);
  scene.materials[0].ambient = glm::dvec3(0.5);
  scene.materials[0].diffuse = glm::dvec3(0.4, 0.4, 0.9);
  scene.materials[0].specular = glm::dvec3(0.2);
  scene.materials[0].shininess = 10;
  scene.ambient = glm::dvec3(0.2);
  scene.lights.emplace_back();
  const Vertex v = project(scene, view_of(kMiddle)).triangles.at(0)[0];
  EXPECT_NEAR(v.r, 255 * (0.2 * 0.5 + 0.4 + 0.2), 1e-3);
  EXPECT_NEAR(v.g, 255 * (0.2 * 0.5 * 0.5 + 0.4 * 0.5 + 0.2), 1e-3);
  EXPECT_EQ(v.b, 255);
  scene.lights[0].direction = {0, 0, 1};  // from behind
  EXPECT_NEAR(project(scene, view_of(kMiddle)).triangles.at(0)[0].r, 255 * 0.2 * 0.5, 1e-9);
}

}  // namespace
}  // namespace halfspace::ref
