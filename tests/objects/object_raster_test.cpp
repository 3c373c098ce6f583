// SPDX-License-Identifier: Apache-2.0
// What an object is drawn as: the triangles of Geometry, passes that merge to the whole, planes of depth that hold.
#include <gtest/gtest.h>

#include <string>

#include "tests/objects/small_scene.hpp"

namespace halfspace::ref {
namespace {

// More triangles than there are indices are drawn in passes, wherever these begin: the merge, a pass after the other,
// gives the whole, with the first pass where keys are equal.
TEST(ObjectBuffer, PassesMergeToTheWhole) {
  const RasterFormat format = format_of(5);
  Scene scene = small_scene();
  Motion motion(3);
  for (int run = 0; run < 50; ++run) {
    motion.begin(scene);
    AllObjects all(scene, format, kWidth, kHeight);
    all.draw();
    const int indices = 1 + motion.below(20);
    ObjectRaster raster(scene, format, kWidth, kHeight);
    ObjectBuffer merged(kWidth, kHeight, full_depth(format.depth_bits)), pass = merged;
    int used = 0;
    const auto finish = [&] {
      for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
          if (pass.at(x, y).key < merged.at(x, y).key) merged.at(x, y) = pass.at(x, y);
        }
      }
      pass.clear(pass.frame());
      used = 0;
    };
    for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
      std::uint32_t last = ~0u;
      raster.fragments(n, merged.frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t triangle) {
        if (triangle != last && used++ == indices) finish();
        last = triangle;
        pass.test(x, y, object_key(depth, n + 1), triangle);
      });
    }
    finish();
    ASSERT_TRUE(same_objects(merged, all.picture()));
  }
}

// A scene by Geometry, snapped, and one object after the other. Returns how many triangles clipping has made.
int expect_geometry(const Scene& scene, const RasterFormat& format, int width, int height) {
  const View view{width, height, format.range_bits, format.subpixel_bits};
  const SnappedList list = snap(Geometry(scene, view).positions(), format);
  ObjectRaster raster(scene, format, width, height);
  std::size_t k = 0;
  int parts = 0;
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
    raster.triangles(n, [&](const SnappedTriangle& t, std::uint32_t number) {
      parts += part_of(number) != 0;
      if (k == list.triangles.size()) FAIL() << "more than " << k;
      const SnappedTriangle& expected = list.triangles[k++];
      ASSERT_TRUE(t.x == expected.x && t.y == expected.y && t.depth == expected.depth) << "triangle " << k;
    });
  }
  EXPECT_EQ(k, list.triangles.size());
  return parts;
}

TEST(ObjectRaster, TrianglesAreThoseOfGeometry) {
  const RasterFormat format{"static", 160, 120, 1 << 20, 8, 8, 24};
  int clipped = 0;
  for (const std::string& name : builtin_scene_names()) {
    SCOPED_TRACE(name);
    Scene scene = load_scene(name);
    expect_geometry(scene, format, 160, 120);
    // From so near that the near plane and the guard band cut it.
    const Viewpoint far_off = viewpoint(scene, 4 / 3.0);
    const DepthPlanes planes = depth_planes(scene, 4 / 3.0);
    Camera camera;
    camera.position = far_off.eye + (planes.near + 0.1 * (planes.far - planes.near)) * far_off.forward;
    camera.forward = far_off.forward;
    camera.up = far_off.up;
    camera.half_height = 1.2;
    camera.near = 0.02 * (planes.far - planes.near);
    scene.camera = camera;
    clipped += expect_geometry(scene, format, 160, 120);
  }
  EXPECT_GT(clipped, 100);
}

TEST(DepthPlanes, HoldOverTheTimesOfAnAnimation) {
  Scene first = load_scene("wheel_in_out", 0.2), second = load_scene("wheel_in_out", 0.9);
  const double aspect = 4 / 3.0;
  ASSERT_NE(viewpoint(first, aspect), viewpoint(second, aspect));
  const DepthPlanes planes = joined(depth_planes(first, aspect), depth_planes(second, aspect));
  EXPECT_EQ(planes.near, depth_planes(first, aspect).near);
  EXPECT_EQ(planes.far, depth_planes(second, aspect).far);
  first.depth_planes = second.depth_planes = planes;
  EXPECT_EQ(viewpoint(first, aspect), viewpoint(second, aspect));
  EXPECT_EQ(depth_planes(first, aspect).far, planes.far);
}

}  // namespace
}  // namespace halfspace::ref
