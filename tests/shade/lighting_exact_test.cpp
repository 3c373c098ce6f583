// SPDX-License-Identifier: Apache-2.0
// The arithmetic of hls/shade/lighting.hpp, bit by bit, against integers. How near it is to the model of light is
// measured by lighting_test.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hls/shade/lighting.hpp"
#include "tests/shade/lit_configs.hpp"

namespace halfspace::tests {
namespace {

// floor(x·2^−places + ½)
std::int64_t rounded(std::int64_t x, int places) {
  return places == 0 ? x : (x + (std::int64_t(1) << (places - 1))) >> places;
}

// Every cosine, squared as often as a material may ask for; each square is rounded.
template <class F>
void expect_powers() {
  using Cosine = typename F::Cosine;
  const int u = Cosine::fraction();
  for (int k = 0; k <= kMostSquarings; ++k) {
    for (std::int64_t x = 0; x <= std::int64_t(1) << u; ++x) {
      std::int64_t want = x;
      for (int j = 0; j < k && j < F::kSquarings; ++j) want = rounded(want * want, u);
      ASSERT_EQ(std::int64_t(raw(power<F>(from_raw<Cosine>(x), k))), want) << x << ", " << k << " squarings";
    }
  }
}
TEST(LightingExact, PowersAreRounded) {
  expect_powers<Formats<LitLow, Stamp1>>();
  expect_powers<Formats<LitMiddle, Stamp1>>();
  expect_powers<Formats<LitHigh, Stamp1>>();
}

// Half up, and full scale at most.
template <class F>
void expect_colours() {
  using Sum = typename F::LightSum;
  const std::int64_t full = (std::int64_t(1) << F::Colour::width()) - 1, one = std::int64_t(1) << Sum::fraction();
  for (std::int64_t colour = 0; colour <= full + 2; ++colour) {
    for (const std::int64_t place : {std::int64_t(0), one / 2 - 1, one / 2, one / 2 + 1, one - 1}) {
      const std::int64_t sum = colour * one + place;
      const std::int64_t want = std::min(rounded(sum, Sum::fraction()), full);
      ASSERT_EQ(std::int64_t(raw(rounded_colour<F>(from_raw<Sum>(sum)))), want) << sum;
    }
  }
  EXPECT_EQ(std::int64_t(raw(rounded_colour<F>(from_raw<Sum>(-1)))), full);
}
TEST(LightingExact, ColoursAreRoundedAndNoMoreThanFull) {
  expect_colours<Formats<LitLow, Stamp1>>();
  expect_colours<Formats<LitMiddle, Stamp1>>();
  expect_colours<Formats<LitHigh, Stamp1>>();
}

// Normals of every length against directions of every length up to 1, along them, across, and away.
template <class F>
void expect_cosines() {
  using Normal = typename F::Normal;
  using Direction = typename F::Direction;
  using Projection = typename F::Projection;
  const int p = Normal::fraction(), d = Direction::fraction(), u = F::Cosine::fraction();
  const int dot_bits = F::Dot::width(), cut = F::Dot::fraction() - Projection::fraction();
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> part(-1, 1);
  int whole = 0, none = 0;
  for (int n = 0; n < 200000; ++n) {
    double a[3], b[3], longest = 0;
    for (int i = 0; i < 3; ++i) a[i] = part(random), b[i] = n % 3 ? part(random) : a[i];
    if (n % 5 == 0) a[0] = a[1] = 0, b[2] = n % 2 ? b[2] : 0;
    for (const double x : b) longest += x * x;
    longest = std::sqrt(longest) + 1e-3;
    const double length = n % 7 == 0 ? 0.01 : 1;
    typename F::Normal normal[3];
    typename F::Direction to[3];
    std::int64_t dot = 0;
    for (int i = 0; i < 3; ++i) {
      const auto x = std::int64_t(std::floor(a[i] * length * ((std::int64_t(1) << p) - 1)));
      const auto y = std::int64_t(std::floor(b[i] / longest * ((std::int64_t(1) << d) - 1)));
      normal[i] = from_raw<Normal>(x), to[i] = from_raw<Direction>(y);
      dot += x * y;
    }
    const ReciprocalRoot<F> inverse = reciprocal_length<F>(normal);
    const typename F::Dot got_dot = dot_product<F>(normal, to);
    ASSERT_EQ(std::int64_t(raw(got_dot)), dot);
    std::int64_t want = 0;
    if (dot > 0) {
      const std::uint64_t scaled = std::uint64_t(dot) << raw(inverse.shift) & ((std::uint64_t(1) << dot_bits) - 1);
      const std::int64_t most = (std::int64_t(1) << Projection::width()) - 1;
      const std::int64_t projection = std::min(rounded(std::int64_t(scaled), cut), most);
      want = rounded(projection * std::int64_t(raw(inverse.root)), Projection::fraction() + kRootFraction - u);
      want = std::min(want, std::int64_t(1) << u);
    }
    whole += want == std::int64_t(1) << u, none += want == 0;
    ASSERT_EQ(std::int64_t(raw(cosine<F>(got_dot, inverse))), want) << dot;
  }
  EXPECT_GT(none, 1000);
  EXPECT_LT(none, 150000);
}
TEST(LightingExact, CosinesAreRounded) {
  expect_cosines<Formats<LitLow, Stamp1>>();
  expect_cosines<Formats<LitMiddle, Stamp1>>();
  expect_cosines<Formats<LitHigh, Stamp1>>();
}

}  // namespace
}  // namespace halfspace::tests
