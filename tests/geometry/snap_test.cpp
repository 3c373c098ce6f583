// SPDX-License-Identifier: Apache-2.0
// Snapping to sub-pixels, depths and colours, and what does not fit.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/geometry/three_formats.hpp"
#include "tests/raster/random_triangles.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {
namespace {

TriangleList one_vertex(double x, double y, double z = 0, double colour = 0) {
  return {8, 8, {0, 0, 0}, {{{{x, y, z, colour, 0, 0}, {1, 2, 0, 0, 0, 0}, {3, 4, 0, 0, 0, 0}}}}};
}

TEST(Snap, TiesGoToEven) {
  const double half = 1.0 / 32;  // of a sub-pixel of low
  const double cases[][2] = {{half, 0},
                             {3 * half, 2},
                             {5 * half, 2},
                             {-half, 0},
                             {-3 * half, -2},
                             {2 * half, 1},
                             {std::nextafter(half, 1), 1}};
  for (const auto& [pixels, expected] : cases) {
    const SnappedTriangle t = snap(one_vertex(pixels, -pixels), kLow).triangles[0];
    EXPECT_EQ(t.x[0], expected);
    EXPECT_EQ(t.y[0], -expected);
  }
}

TEST(Snap, DepthAndColourReachTheirEnds) {
  const SnappedTriangle t = snap(one_vertex(0, 0, 1, 254.5), kLow).triangles[0];
  EXPECT_EQ(t.depth[0], 65535u);
  EXPECT_EQ(t.rgb[0][0], 255);
  EXPECT_EQ(snap(one_vertex(0, 0, 0.5), kMiddle).triangles[0].depth[0], 8388608u);
}

TEST(Snap, RefusesAndNamesWhatFits) {
  TriangleList list = one_vertex(0, 0);
  list.width = 640;
  expect_in("640x8 pixels does not fit configuration low", refusal([&] { snap(list, kLow, kAll); }));
  expect_in("configuration middle takes it", refusal([&] { snap(list, kLow, kAll); }));
  list.height = 2000;
  expect_in("no configuration takes it", refusal([&] { snap(list, kLow, kAll); }));

  list = one_vertex(0, 0);
  list.triangles.resize(20000, list.triangles[0]);
  expect_in("20000 triangles do not fit configuration low, which takes 4096; configuration high takes it",
            refusal([&] { snap(list, kLow, kAll); }));

  snap(one_vertex(-512, 511.96), kLow);
  expect_in("triangle 1, vertex 0: y = 511.97", refusal([] { snap(one_vertex(0, 511.97), kLow, kAll); }));
  expect_in("[-512, 512) pixels; configuration middle takes it", refusal([] { snap(one_vertex(512, 0), kLow, kAll); }));
  expect_in("x = -512.1", refusal([] { snap(one_vertex(-512.1, 0), kLow); }));
  expect_in("x = 1e+300", refusal([] { snap(one_vertex(1e300, 0), kHigh, kAll); }));
}

TEST(Snap, UnsnapIsItsInverse) {
  Random random(2);
  for (const RasterFormat& format : kAll) {
    std::vector<SnappedTriangle> triangles;
    for (int k = 0; k < 1000; ++k) triangles.push_back(random_triangle(random, 2000, format.depth_bits));
    const SnappedList list = list_of(format, 64, 64, triangles), back = snap(unsnap(list), format);
    EXPECT_EQ(back.background, list.background);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      const SnappedTriangle &a = list.triangles[k], &b = back.triangles[k];
      ASSERT_TRUE(a.x == b.x && a.y == b.y && a.depth == b.depth && a.rgb == b.rgb);
    }
  }
}

}  // namespace
}  // namespace halfspace::ref
