// SPDX-License-Identifier: Apache-2.0
// The arithmetic of hls/setup/reciprocal.hpp and hls/setup/plane.hpp against 128-bit integers. What it comes to at
// pixels, for every kind of triangle, is measured by bounds_test.
#include <gtest/gtest.h>

#include <random>

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "hls/pipeline/pipeline.hpp"
#include "study/bounds/bounds_exact.hpp"

namespace halfspace::tests {
namespace {

using model::Wide;

// R = round(2^(r+s) / D), ties up, for every kind of D.
template <class F>
void expect_reciprocal() {
  std::mt19937_64 random(5);
  const int r = F::kReciprocalFraction;
  for (int n = 0; n < 200000; ++n) {
    const int width = 1 + n % F::Area::width();
    std::uint64_t area = (random() & ((std::uint64_t(1) << width) - 1)) | std::uint64_t(1) << (width - 1);
    if (n % 7 == 0) area = std::uint64_t(1) << (width - 1);
    if (n % 7 == 1) area = (std::uint64_t(1) << width) - 1;
    const auto result = area_reciprocal<F>(from_raw<typename F::Area>(area));
    int s = 63;
    while (!(area >> s)) --s;
    const Wide exact = ((Wide(1) << (r + s + 1)) + Wide(area)) / (2 * Wide(area));
    ASSERT_EQ(int(raw(result.shift)), s) << "D = " << area;
    ASSERT_EQ(std::uint64_t(raw(result.reciprocal)), std::uint64_t(exact)) << "D = " << area;
    ASSERT_GE(std::uint64_t(exact), std::uint64_t(1) << (r - 1));
    ASSERT_LE(std::uint64_t(exact), std::uint64_t(1) << r);
  }
  // The largest areas come to 2^(r−1) itself.
  const auto largest = area_reciprocal<F>(from_raw<typename F::Area>((std::uint64_t(1) << F::Area::width()) - 1));
  EXPECT_EQ(std::uint64_t(raw(largest.reciprocal)), std::uint64_t(1) << (r - 1));
}
TEST(Reciprocal, IsRoundedCorrectly) {
  expect_reciprocal<Formats<Low, Stamp1>>();
  expect_reciprocal<Formats<Middle, Stamp1>>();
  expect_reciprocal<Formats<High, Stamp1>>();
}

// floor(N·R·2^−n + ½) modulo its width: the halves of the product lose nothing.
template <class F, class Channel>
void expect_product() {
  std::mt19937_64 random(9);
  using Gradient = typename Channel::StartGradient;
  const int bits = Channel::Numerator::width() - 1, r = F::kReciprocalFraction;
  for (int k = 0; k < 200000; ++k) {
    const std::uint64_t mask = (std::uint64_t(1) << (1 + k % bits)) - 1;
    std::int64_t numerator = std::int64_t(k % 5 == 0 ? mask : random() & mask);
    if (k % 2) numerator = -numerator;
    const std::uint64_t reciprocal = (std::uint64_t(1) << (r - 1)) + random() % ((std::uint64_t(1) << (r - 1)) + 1);
    const int shift = int(random() % F::Area::width());  // s
    const int n = shift + r - F::kSubpixelBits - Channel::PlaneValue::fraction();
    const Wide half = n > 0 ? Wide(1) << (n - 1) : 0;
    const Wide exact = (Wide(numerator) * Wide(reciprocal) + half) >> n;
    const auto got = rounded_product<Gradient>(from_raw<typename Channel::Numerator>(numerator),
                                               from_raw<typename F::Reciprocal>(reciprocal), n);
    ASSERT_EQ(raw(got), raw(from_raw<Gradient>(std::uint64_t(exact))))
        << numerator << " * " << reciprocal << " / 2^" << n;
  }
}
TEST(RoundedProduct, OfANumeratorAndAReciprocal) {
  expect_product<Formats<Low, Stamp1>, Formats<Low, Stamp1>::DepthChannel>();
  expect_product<Formats<Low, Stamp1>, Formats<Low, Stamp1>::ColourChannel>();
  expect_product<Formats<Middle, Stamp1>, Formats<Middle, Stamp1>::DepthChannel>();
  expect_product<Formats<Middle, Stamp1>, Formats<Middle, Stamp1>::ColourChannel>();
  expect_product<Formats<High, Stamp1>, Formats<High, Stamp1>::DepthChannel>();
  expect_product<Formats<High, Stamp1>, Formats<High, Stamp1>::ColourChannel>();
}

// Vertex 0 is one of those given, and the others follow it, or follow it backwards.
TEST(Vertices, AreThoseGivenInOrder) {
  using F = Formats<Low, Stamp1>;
  for (int first = 0; first < 3; ++first) {
    for (const bool turned : {false, true}) {
      Attributes<F> in{};
      in.first = from_raw<VertexNumber>(first);
      in.turned = from_raw<Bit>(turned);
      VertexOrder order = {{7, 7, 7}};
      order = vertex_order(in);
      const F::Colour given[3] = {from_raw<F::Colour>(10), from_raw<F::Colour>(11), from_raw<F::Colour>(12)};
      F::Colour ordered[3] = {};
      put_in_order(given, order, ordered);
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(order.vertex[i], (first + (turned ? 3 - i : i)) % 3) << first << turned << i;
        EXPECT_EQ(int(raw(ordered[i])), 10 + order.vertex[i]);
      }
    }
  }
}

}  // namespace
}  // namespace halfspace::tests
