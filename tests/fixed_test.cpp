// SPDX-License-Identifier: Apache-2.0
// The number type against integers of 128 bits: every operator exact, every assignment a floor and a wrap.
#include <gtest/gtest.h>

#include <random>

#include "hls/fixed.hpp"

namespace halfspace::tests {
namespace {

using Wide = __int128;

// x · 2^32: an integer for every format below.
template <int W, int I, bool S>
Wide scaled(const Fixed<W, I, S>& x) {
  return Wide(raw(x)) * (Wide(1) << (32 - (W - I)));
}

Wide floor_wrap(Wide value, int width, int fraction, bool is_signed) {
  Wide v = value >> (32 - fraction);  // arithmetic: floor
  const Wide period = Wide(1) << width;
  v = ((v % period) + period) % period;
  if (is_signed && v >= period / 2) v -= period;
  return v;
}

template <class A, class B>
void expect_pair(std::mt19937_64& random) {
  for (int n = 0; n < 3000; ++n) {
    const A a = from_raw<A>(std::int64_t(random()));
    const B b = from_raw<B>(std::int64_t(random()));
    const auto sum = a + b;
    const auto difference = a - b;
    const auto product = a * b;
    ASSERT_EQ(scaled(sum), scaled(a) + scaled(b));
    ASSERT_EQ(scaled(difference), scaled(a) - scaled(b));
    ASSERT_EQ(Wide(raw(product)), Wide(raw(a)) * Wide(raw(b)));
    const B narrowed = a;
    ASSERT_EQ(Wide(raw(narrowed)), floor_wrap(scaled(a), B::kWidth, B::kFraction, B::kSigned));
    const A of_sum = sum;
    ASSERT_EQ(Wide(raw(of_sum)), floor_wrap(scaled(sum), A::kWidth, A::kFraction, A::kSigned));
  }
}

template <class A, class B>
void expect_order(std::mt19937_64& random) {
  for (int n = 0; n < 3000; ++n) {
    const A a = from_raw<A>(std::int64_t(random()));
    const B b = n % 3 ? from_raw<B>(std::int64_t(random())) : B(a);
    ASSERT_EQ(a < b, scaled(a) < scaled(b));
    ASSERT_EQ(a <= b, scaled(a) <= scaled(b));
    ASSERT_EQ(a == b, scaled(a) == scaled(b));
    ASSERT_EQ(a >= b, scaled(a) >= scaled(b));
  }
}

TEST(Fixed, IsExactAndWraps) {
  std::mt19937_64 random(1);
  expect_pair<fix<18, 10>, fix<18, 10>>(random);
  expect_pair<fix<22, 14>, fix<9, 9>>(random);
  expect_pair<fix<23, 15>, ufix<24, 24>>(random);
  expect_pair<ufix<8, 8>, ufix<9, 8>>(random);
  expect_pair<ufix<24, 8>, fix<31, 20>>(random);
  expect_pair<fix<31, 21>, fix<32, 22>>(random);
  expect_pair<ufix<1, 1>, fix<30, 0>>(random);
  expect_pair<ufix<31, 0>, ufix<31, 31>>(random);
  expect_order<fix<18, 10>, fix<31, 20>>(random);
  expect_order<ufix<24, 24>, ufix<24, 8>>(random);
}

TEST(Fixed, Negates) {
  std::mt19937_64 random(2);
  using T = fix<40, 30>;
  for (int n = 0; n < 2000; ++n) {
    const T x = from_raw<T>(std::int64_t(random()));
    ASSERT_EQ(scaled(-x), -scaled(x));
  }
  // The most negative value has no negative of its own width.
  ASSERT_EQ(raw(-from_raw<fix<8, 8>>(-128)), 128);
}

}  // namespace
}  // namespace halfspace::tests
