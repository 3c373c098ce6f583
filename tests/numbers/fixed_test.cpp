// SPDX-License-Identifier: Apache-2.0
// The numbers against integers of 128 bits: every operator exact, every assignment a floor and a wrap. Compiled for
// each kind of numbers that fixed.hpp knows.
#include <gtest/gtest.h>

#include <random>

#include "hls/numbers/fixed.hpp"

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

template <class To, class From>
void expect_conversion(std::mt19937_64& random) {
  for (int n = 0; n < 3000; ++n) {
    // Trailing zeros, because whole words of them are a special case in libraries.
    const From x = from_raw<From>(random() << (n % 4 * 16));
    const To y = x;
    ASSERT_EQ(Wide(raw(y)), floor_wrap(scaled(x), To::kWidth, To::kFraction, To::kSigned));
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
    ASSERT_EQ(a > b, scaled(a) > scaled(b));
    ASSERT_EQ(a >= b, scaled(a) >= scaled(b));
    ASSERT_EQ(a != b, scaled(a) != scaled(b));
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
  expect_order<fix<62, 40>, fix<62, 40>>(random);
  expect_pair<fix<63, 40>, ufix<1, 1>>(random);
  expect_pair<fix<32, 16>, fix<31, 31>>(random);
}

TEST(Fixed, ConvertsTheWidest) {
  std::mt19937_64 random(3);
  expect_conversion<fix<64, 64>, ufix<64, 64>>(random);
  expect_conversion<ufix<64, 64>, fix<64, 32>>(random);
  expect_conversion<ufix<64, 40>, fix<64, 64>>(random);
  expect_conversion<fix<33, 33>, ufix<64, 32>>(random);
  expect_conversion<ufix<1, 1>, fix<64, 64>>(random);
  expect_conversion<fix<64, 32>, fix<1, 1>>(random);
}

TEST(Fixed, HoldsItsBits) {
  std::mt19937_64 random(4);
  using Signed = fix<64, 20>;
  using Unsigned = ufix<64, 64>;
  for (int n = 0; n < 2000; ++n) {
    const std::uint64_t bits = random() << (n % 4 * 16);
    ASSERT_EQ(raw(from_raw<Unsigned>(bits)), bits);
    ASSERT_EQ(raw(from_raw<Signed>(bits)), std::int64_t(bits));
    // Bits beyond the width are dropped.
    ASSERT_EQ(raw(from_raw<ufix<5, 2>>(bits)), bits % 32);
    ASSERT_EQ(raw(from_raw<fix<5, 2>>(bits)), std::int64_t(bits << 59) >> 59);
  }
  struct Record {
    fix<20, 8> x;
    ufix<40, 40> y[3];
  };
  Record zero{};
  EXPECT_EQ(raw(zero.x), 0);
  for (const auto& y : zero.y) EXPECT_EQ(raw(y), 0u);
  zero.y[1] = from_raw<ufix<40, 40>>(7);
  const Record copy = zero;
  zero = Record{};
  EXPECT_EQ(raw(copy.y[1]), 7u);
  EXPECT_EQ(raw(zero.y[1]), 0u);
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
