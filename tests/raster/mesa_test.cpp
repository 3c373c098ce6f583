// SPDX-License-Identifier: Apache-2.0
// Coverage of the kernels against Mesa's llvmpipe, which has the same 8 sub-pixel bits and the same tie rule. Triangles
// that leave the frame are left to exact arithmetic (raster_pineda_test): Mesa clips them in floating point.
#include <gtest/gtest.h>

#include <random>

#include "tests/raster/kernel_coverage.hpp"
#include "tests/raster/mesa.hpp"

namespace halfspace::tests {
namespace {

TEST(Mesa, CoversTheSamePixels) {
  constexpr int kSize = 128, kOne = 1 << 8;
  Mesa mesa(kSize, kSize);
  CoverageKernel<Formats<Middle, Stamp4>> kernel(kSize, kSize);
  std::mt19937_64 random(42);
  auto in = [&](int low, int high) { return low + int(random() % std::uint64_t(high - low + 1)); };

  int triangles = 0;
  std::uint64_t fragments = 0, differing = 0;
  ref::SnappedList scene;
  scene.format.subpixel_bits = 8;
  scene.format.depth_bits = 24;
  scene.triangles.resize(1);
  for (; triangles < 24000; ++triangles) {
    ref::SnappedTriangle& t = scene.triangles[0];
    t = {};
    const int kind = triangles % 6;
    for (int v = 0; v < 3; ++v) {
      t.x[v] = in(0, kSize * kOne);
      t.y[v] = in(0, kSize * kOne);
      t.rgb[v] = {255, 255, 255};
    }
    if (kind == 1)
      for (int v = 0; v < 3; ++v) t.x[v] = in(40 * kOne, 48 * kOne), t.y[v] = in(60 * kOne, 66 * kOne);
    if (kind == 2)
      for (int v = 0; v < 3; ++v) t.x[v] = in(0, kSize - 1) * kOne + 128, t.y[v] = in(0, kSize - 1) * kOne + 128;
    if (kind == 3) t.x[1] = std::abs(t.x[0] - in(0, 3)), t.y[1] = std::abs(t.y[0] - in(0, 3));
    if (kind == 4) t.y[1] = t.y[0] = in(0, kSize - 1) * kOne + 128;
    if (kind == 5) t.x[1] = t.x[0] = in(0, 2 * kSize) * 128;

    mesa.clear(0, 0, 0);
    const std::vector<std::uint32_t>& picture = mesa.draw(Mesa::arrays(scene));
    const std::vector<int>& covered = kernel.draw(t);
    for (int p = 0; p < kSize * kSize; ++p) {
      const bool by_mesa = (picture[p] & 0xffffff) != 0;
      fragments += by_mesa;
      differing += by_mesa != (covered[p] != 0);
    }
    ASSERT_EQ(differing, 0u) << "triangle " << triangles << " of class " << kind << ": (" << t.x[0] << ", " << t.y[0]
                             << ") (" << t.x[1] << ", " << t.y[1] << ") (" << t.x[2] << ", " << t.y[2] << ") / 256";
  }
  std::printf("%d triangles, %llu fragments of llvmpipe, %llu pixels differ\n", triangles,
              static_cast<unsigned long long>(fragments), static_cast<unsigned long long>(differing));
  EXPECT_GT(fragments, 1000000u);
}

}  // namespace
}  // namespace halfspace::tests
