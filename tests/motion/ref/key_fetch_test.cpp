// SPDX-License-Identifier: Apache-2.0
// What is fetched from a key frame at a place between pixels: weights, ties, taps that do not match.
#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "ref/motion/compensate.hpp"

namespace halfspace::ref {
namespace {

TEST(Weights, SumToOneAndAreSymmetrical) {
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0;
    for (const Filter filter : {Filter::kBilinear, Filter::kArea}) {
      const auto w = axis_weights(filter, t), mirrored = axis_weights(filter, 1 - t);
      EXPECT_NEAR(w[0] + w[1], 1, 1e-15);
      EXPECT_NEAR(w[0], mirrored[1], 1e-15);
      EXPECT_EQ(w[0] > w[1], t < 0.5);
    }
    const auto c = cubic_weights(t), mirrored = cubic_weights(1 - t);
    EXPECT_NEAR(c[0] + c[1] + c[2] + c[3], 1, 1e-15);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(c[k], mirrored[3 - k], 1e-15);
    EXPECT_NEAR(-c[0] + c[2] + 2 * c[3], t, 1e-15);  // a line stays a line
  }
  EXPECT_EQ(axis_weights(Filter::kBilinear, 0.25), (std::array<double, 2>{0.75, 0.25}));
  EXPECT_EQ(axis_weights(Filter::kArea, 0.25), (std::array<double, 2>{0.9, 0.1}));
  EXPECT_EQ(cubic_weights(0.5), (std::array<double, 4>{-1 / 16.0, 9 / 16.0, 9 / 16.0, -1 / 16.0}));
  EXPECT_EQ(cubic_weights(0), (std::array<double, 4>{0, 1, 0, 0}));
}

// --- one fetch ---

// Red counts pixels, all of identity 1 but for those named.
KeyFrame counted(int width, int height, const std::vector<std::array<int, 2>>& others = {}) {
  KeyFrame key{width, height, {}, std::vector<std::uint32_t>(std::size_t(width) * height, 1)};
  for (int i = 0; i < width * height; ++i) key.colour.push_back({std::uint8_t(10 * i), 0, 0, 255});
  for (const auto& [x, y] : others) key.identity[std::size_t(y) * width + x] = 2;
  return key;
}
double red(const KeyFrame& key, double x, double y, Filter filter, std::uint32_t identity = 1, bool test = true) {
  const auto colour = fetch(key, {x, y}, identity, {filter, test, {true, true}, 0});
  return colour ? colour->x : -1;
}

TEST(Fetch, NearestIsThePixelThatThePlaceLiesIn) {
  const KeyFrame key = counted(3, 2, {{1, 1}});  // 0 10 20 / 30 40 50
  EXPECT_EQ(red(key, 2.0, 0.99, Filter::kNearest), 20);
  EXPECT_EQ(red(key, 0.0, 1.0, Filter::kNearest), 30);
  EXPECT_EQ(red(key, 1.5, 1.5, Filter::kNearest), -1);
  EXPECT_EQ(red(key, 1.5, 1.5, Filter::kNearest, 2), 40);
  EXPECT_EQ(red(key, 1.5, 1.5, Filter::kNearest, 1, false), 40);
  for (const auto& [x, y] : {std::pair(-0.01, 0.5), std::pair(3.0, 0.5), std::pair(0.5, 2.0), std::pair(0.5, -0.01)})
    EXPECT_EQ(red(key, x, y, Filter::kNearest, 1, false), -1);
}

TEST(Fetch, BilinearMovesTheWeightOfWhatDoesNotMatch) {
  // At (1.25 − ½, 1.125 − ½) beyond pixel (0, 0): t = 0.75, 0.625; weights 0.09375 0.28125 / 0.15625 0.46875.
  const double x = 1.25, y = 1.125;
  const auto at = [&](const std::vector<std::array<int, 2>>& others) {
    return red(counted(2, 2, others), x, y, Filter::kBilinear);  // 0 10 / 20 30
  };
  EXPECT_DOUBLE_EQ(at({}), 10 * 0.28125 + 20 * 0.15625 + 30 * 0.46875);
  EXPECT_DOUBLE_EQ(at({{0, 0}}), 10 * 0.28125 + 20 * 0.15625 + 30 * (0.46875 + 0.09375));
  // Without the nearest, (1, 1): the neighbour along y, whose fraction is nearer to ½, is (1, 0).
  EXPECT_DOUBLE_EQ(at({{1, 1}}), 10 * (0.28125 + 0.46875) + 20 * 0.15625);
  EXPECT_DOUBLE_EQ(at({{1, 1}, {1, 0}}), 20 * (1 - 0.09375));
  EXPECT_DOUBLE_EQ(at({{1, 1}, {1, 0}, {0, 1}}), 0);
  EXPECT_DOUBLE_EQ(at({{1, 1}, {0, 0}, {0, 1}}), 10);
  EXPECT_EQ(at({{1, 1}, {1, 0}, {0, 1}, {0, 0}}), -1);
  EXPECT_DOUBLE_EQ(red(counted(2, 2, {{1, 1}}), x, y, Filter::kBilinear, 1, false),
                   10 * 0.28125 + 20 * 0.15625 + 30 * 0.46875);
}

TEST(Fetch, TiesGoRightDownAndAlongX) {
  const auto at = [](double x, double y, int other_x, int other_y) {
    return red(counted(2, 2, {{other_x, other_y}}), x, y, Filter::kBilinear);  // 0 10 / 20 30
  };
  EXPECT_DOUBLE_EQ(at(1, 0.75, 0, 1), 10 * (0.375 + 0.125) + 30 * 0.125);
  EXPECT_DOUBLE_EQ(at(0.75, 1, 1, 0), 20 * (0.375 + 0.125) + 30 * 0.125);
  EXPECT_DOUBLE_EQ(at(1.25, 1.25, 1, 1), 10 * 0.1875 + 20 * (0.1875 + 0.5625));
}

TEST(Fetch, BilinearAtTheSideOfTheFrame) {
  const KeyFrame key = counted(2, 2);
  EXPECT_DOUBLE_EQ(red(key, 0.25, 0.5, Filter::kBilinear), 0);     // the tap outside gives its weight away
  EXPECT_DOUBLE_EQ(red(key, 1.75, 1.0, Filter::kBilinear), 22.5);  // of 10 and 30 the lower one counts as nearest
  EXPECT_DOUBLE_EQ(red(key, -0.25, 1.75, Filter::kBilinear), 20);
  EXPECT_EQ(red(key, -0.49, 0.5, Filter::kBilinear), 0);
  EXPECT_EQ(red(key, -0.5, 0.5, Filter::kBilinear), -1);  // the tap in the frame has no weight
  EXPECT_EQ(red(key, 2.5, 0.5, Filter::kBilinear), -1);
  EXPECT_EQ(red(key, 1e30, -1e30, Filter::kBilinear), -1);
}

TEST(Fetch, BicubicNeedsAllItsTaps) {
  const double by_hand = [] {
    const auto across = cubic_weights(0.25), down = cubic_weights(0.5);
    double sum = 0;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) sum += across[i] * down[j] * (10 * (4 * j + i));
    }
    return sum;
  }();
  EXPECT_NEAR(red(counted(4, 4), 1.75, 2, Filter::kBicubic), by_hand, 1e-12);
  const KeyFrame without = counted(4, 4, {{3, 0}});
  EXPECT_DOUBLE_EQ(red(without, 1.75, 2, Filter::kBicubic), red(without, 1.75, 2, Filter::kBilinear));
  EXPECT_DOUBLE_EQ(red(counted(4, 4), 1.25, 2, Filter::kBicubic), red(counted(4, 4), 1.25, 2, Filter::kBilinear));
}

TEST(Fetch, OneColourStaysThatColour) {
  for (int others = 0; others < 15; ++others) {
    KeyFrame key = counted(2, 2);
    for (int i = 0; i < 4; ++i) {
      key.identity[i] = others >> i & 1 ? 2 : 1;
      key.colour[i] =
          key.identity[i] == 1 ? std::array<std::uint8_t, 4>{77, 5, 200, 255} : std::array<std::uint8_t, 4>{};
    }
    for (const Filter filter : {Filter::kBilinear, Filter::kArea, Filter::kBicubic}) {
      for (int i = 1; i < 100; ++i) {
        const auto colour = fetch(key, {0.55 + i % 10 / 10.0, 0.5 + i / 100.0}, 1, {filter, true, {true, true}, 0});
        ASSERT_TRUE(colour);
        EXPECT_LT(glm::distance(*colour, glm::dvec3(77, 5, 200)), 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace halfspace::ref
