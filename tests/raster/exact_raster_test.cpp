// SPDX-License-Identifier: Apache-2.0
// The exact rasterizer against arithmetic that is done another way.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/geometry/three_formats.hpp"
#include "tests/raster/random_triangles.hpp"

namespace halfspace::ref {
namespace {

__extension__ typedef __int128 Wide;

// The same plane as a mean of the vertices, weighted by the areas opposite of them: no gradients.
Wide weighted(const SnappedTriangle& t, const std::array<std::int64_t, 3>& value, std::int64_t px, std::int64_t py,
              std::int64_t* area) {
  Wide sum = 0;
  *area = 0;
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const std::int64_t weight = (t.x[a] - px) * (t.y[b] - py) - (t.y[a] - py) * (t.x[b] - px);
    sum += Wide(weight) * value[i];
    *area += weight;
  }
  if (*area < 0) sum = -sum, *area = -*area;
  return sum;
}

TEST(Raster, IsTheSameAsPixelByPixel) {
  Random random(3);
  constexpr int kSide = 40, kBits = 8;
  std::vector<SnappedTriangle> triangles;
  for (int k = 0; k < 600; ++k) triangles.push_back(random_triangle(random, k % 2 ? 12000 : 260000, 24));
  const SnappedList list = list_of(kMiddle, kSide, kSide, triangles);
  const Frame frame = render(list);
  std::vector<bool> visible(triangles.size(), false);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const std::int64_t px = x * 256 + 128, py = y * 256 + 128;
      std::int64_t depth = full_depth(24), area;
      std::uint32_t index = 0;
      for (std::uint32_t k = 1; k <= triangles.size(); ++k) {
        const SnappedTriangle& t = triangles[k - 1];
        if (!covers(t, kBits, x, y)) continue;
        const Wide sum = weighted(t, {t.depth[0], t.depth[1], t.depth[2]}, px, py, &area);
        const auto fragment = static_cast<std::int64_t>((2 * sum + area) / (2 * Wide(area)));
        if (fragment < depth) depth = fragment, index = k, visible[k - 1] = true;
      }
      const std::size_t at = std::size_t(y) * kSide + x;
      ASSERT_EQ(frame.index[at], index) << x << ", " << y;
      ASSERT_EQ(frame.depth[at], depth) << x << ", " << y;
      if (index == 0) continue;
      const SnappedTriangle& t = triangles[index - 1];
      for (int c = 0; c < 3; ++c) {
        const Wide sum = weighted(t, {t.rgb[0][c], t.rgb[1][c], t.rgb[2][c]}, px, py, &area);
        ASSERT_EQ(frame.colour[at][c], static_cast<int>((2 * sum + area) / (2 * Wide(area))));
        ASSERT_NEAR(frame.exact_colour[at][c], double(sum) / double(area), 1e-9);
      }
      ASSERT_LE(std::abs(frame.exact_depth[at] - double(depth)), 0.5 + 1e-6);
    }
  }
  EXPECT_EQ(frame.visible, visible);
}

TEST(Raster, AnyOrderOfTheVerticesIsTheSameTriangle) {
  Random random(4);
  for (int k = 0; k < 300; ++k) {
    const SnappedTriangle t = random_triangle(random, 6000, 24);
    const Frame first = render(list_of(kMiddle, 24, 24, {t}));
    std::array<int, 3> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
      SnappedTriangle turned;
      for (int v = 0; v < 3; ++v) {
        const int from = order[v];
        turned.x[v] = t.x[from], turned.y[v] = t.y[from], turned.depth[v] = t.depth[from], turned.rgb[v] = t.rgb[from];
      }
      const Frame frame = render(list_of(kMiddle, 24, 24, {turned}));
      ASSERT_EQ(frame.index, first.index);
      ASSERT_EQ(frame.depth, first.depth);
      ASSERT_EQ(frame.colour, first.colour);
    }
  }
}

// Corners on a jittered grid, many of them on pixel centres, with the border straight: every centre belongs
// to one.
TEST(Raster, MeshHasNoHolesAndNoDoubles) {
  Random random(5);
  for (int run = 0; run < 20; ++run) {
    constexpr int kCells = 12, kCell = 4 * 16, kSide = kCells * kCell / 16;
    std::array<std::int32_t, 2> corner[kCells + 1][kCells + 1];
    for (int i = 0; i <= kCells; ++i) {
      for (int j = 0; j <= kCells; ++j) {
        const int step = run % 2 ? 1 : 8;
        const auto jitter = [&](int at) { return at == 0 || at == kCells ? 0 : pick(random, -2, 2) * step; };
        corner[i][j] = {j * kCell + jitter(j), i * kCell + jitter(i)};
      }
    }
    std::vector<int> count(kSide * kSide, 0);
    for (int i = 0; i < kCells; ++i) {
      for (int j = 0; j < kCells; ++j) {
        const auto &a = corner[i][j], &b = corner[i][j + 1], &c = corner[i + 1][j + 1], &d = corner[i + 1][j];
        const SnappedTriangle pair[2] = {{{a[0], b[0], c[0]}, {a[1], b[1], c[1]}, {}, {}},
                                         {{a[0], d[0], c[0]}, {a[1], d[1], c[1]}, {}, {}}};
        for (const SnappedTriangle& t : pair) {
          const Frame frame = render(list_of(kLow, kSide, kSide, {t}));
          for (std::size_t at = 0; at < count.size(); ++at) count[at] += frame.index[at] != 0;
        }
      }
    }
    ASSERT_EQ(std::count(count.begin(), count.end(), 1), kSide * kSide) << "run " << run;
  }
}

SnappedTriangle whole_frame(std::uint32_t depth) {
  return {{-1000, 8000, -1000}, {-1000, -1000, 8000}, {depth, depth, depth}, {{{9, 9, 9}, {9, 9, 9}, {9, 9, 9}}}};
}

TEST(Raster, EqualDepthsComeBackAndTheFirstWins) {
  const Frame frame =
      render(list_of(kMiddle, 8, 8, {whole_frame(1234567), whole_frame(1234567), whole_frame(1234566)}));
  EXPECT_EQ(frame.index, std::vector<std::uint32_t>(64, 3));
  EXPECT_EQ(frame.depth, std::vector<std::uint32_t>(64, 1234566));
  EXPECT_EQ(frame.visible, (std::vector<bool>{true, false, true}));
  EXPECT_EQ(frame.exact_depth, std::vector<double>(64, 1234566));
  EXPECT_EQ(frame.exact_colour[0], (std::array<double, 3>{9, 9, 9}));
}

TEST(Raster, FullDepthIsNeverDrawn) {
  const Frame frame = render(list_of(kMiddle, 8, 8, {whole_frame(full_depth(24))}));
  EXPECT_EQ(covered(frame), 0u);
  EXPECT_EQ(frame.visible, std::vector<bool>{false});
  EXPECT_EQ(frame.depth[0], full_depth(24));
  EXPECT_EQ(frame.colour[0], (std::array<std::uint8_t, 4>{1, 2, 3, 255}));
  EXPECT_EQ(covered(render(list_of(kMiddle, 8, 8, {whole_frame(full_depth(24) - 1)}))), 64u);
}

TEST(Raster, NoAreaDrawsNothing) {
  SnappedTriangle t = whole_frame(0);
  t.x[2] = t.x[0], t.y[2] = t.y[0];
  EXPECT_EQ(covered(render(list_of(kMiddle, 8, 8, {t}))), 0u);
  EXPECT_FALSE(covers(t, 8, 0, 0));
}

}  // namespace
}  // namespace halfspace::ref
