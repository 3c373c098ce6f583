// SPDX-License-Identifier: Apache-2.0
// The functions of arithmetic.hpp against integers of 128 bits: every value of short numbers, extreme and random ones
// of long ones. Compiled for each kind of numbers that fixed.hpp knows.
#include "hls/numbers/arithmetic.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>
#include <vector>

namespace halfspace::tests {
namespace {

using Wide = __int128;

constexpr int kValues = 60;

// The bits of T: all of them if it is short.
template <class T>
std::vector<std::uint64_t> bits_of() {
  if (T::kWidth <= 5) {
    std::vector<std::uint64_t> all(std::size_t(1) << T::kWidth % 6);
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const std::uint64_t top = std::uint64_t(1) << (T::kWidth - 1);
  std::vector<std::uint64_t> bits = {
      0, 1, 2, top, top - 1, top + 1, 2 * top - 1, top / 3, (std::uint64_t(1) << 24) - 1, std::uint64_t(1) << 24};
  std::mt19937_64 random(T::kWidth);
  while (bits.size() < kValues) bits.push_back(random() >> random() % 64);
  return bits;
}

// What T holds of these bits.
template <class T>
Wide wrapped(Wide bits) {
  const Wide period = Wide(1) << T::kWidth;
  const Wide v = ((bits % period) + period) % period;
  return T::kSigned && v >= period / 2 ? v - period : v;
}

template <class T>
void expect_unary() {
  for (const std::uint64_t bits : bits_of<T>()) {
    const T x = from_raw<T>(bits);
    const Wide v = wrapped<T>(Wide(bits));
    ASSERT_EQ(is_zero(x), v == 0);
    ASSERT_EQ(is_negative(x), v < 0);
    for (int n = 0; n < 64; ++n) {
      ASSERT_EQ(Wide(raw(shift_left(x, n))), wrapped<T>(v << n)) << raw(x) << " << " << n;
      ASSERT_EQ(Wide(raw(shift_right(x, n))), v >> n) << raw(x) << " >> " << n;
    }
    for (int from = 0; from < T::kWidth; ++from) {
      using Short = ufix<7, 3>;
      using Long = fix<40, 0>;
      ASSERT_EQ(Wide(raw(slice<Short>(x, from))), wrapped<Short>(v >> from));
      ASSERT_EQ(Wide(raw(slice<Long>(x, from))), wrapped<Long>(v >> from));
    }
  }
}
TEST(Arithmetic, ShiftsAndSlices) {
  expect_unary<fix<5, 2>>();
  expect_unary<ufix<5, 5>>();
  expect_unary<ufix<1, 1>>();
  expect_unary<fix<32, 11>>();
  expect_unary<ufix<32, 0>>();
  expect_unary<fix<33, 33>>();
  expect_unary<fix<64, 7>>();
  expect_unary<ufix<64, 64>>();
}

// The bits of T from the top one of X down.
template <class T, class X>
void expect_leading() {
  const int more = X::kWidth - T::kWidth;
  for (const std::uint64_t bits : bits_of<X>()) {
    const Wide v = wrapped<X>(Wide(bits));
    ASSERT_EQ(Wide(raw(leading<T>(from_raw<X>(bits)))), wrapped<T>(more >= 0 ? v >> more : v << -more)) << bits;
  }
}
TEST(Arithmetic, LeadingBitsAreCutOrFilled) {
  expect_leading<ufix<5, 5>, ufix<5, 2>>();
  expect_leading<ufix<3, 1>, ufix<5, 2>>();
  expect_leading<ufix<21, 9>, ufix<16, 16>>();
  expect_leading<ufix<21, 9>, ufix<45, 45>>();
  expect_leading<ufix<40, 9>, ufix<10, 10>>();
  expect_leading<ufix<64, 9>, ufix<1, 1>>();
}

template <class T>
void expect_low_bits() {
  for (const std::uint64_t bits : bits_of<T>()) {
    const T x = from_raw<T>(bits);
    const Wide v = wrapped<T>(Wide(bits));
    for (int n = 0; n <= T::kWidth; ++n) {
      const T low = low_bits(x, n);
      ASSERT_EQ(Wide(raw(low)), v % (Wide(1) << n)) << bits << " mod 2^" << n;
      ASSERT_TRUE(merged(low, T(x - low)) == x) << bits;
    }
  }
}
TEST(Arithmetic, LowBitsAndTheRestAreTheNumber) {
  expect_low_bits<ufix<1, 1>>();
  expect_low_bits<ufix<5, 2>>();
  expect_low_bits<ufix<32, 20>>();
  expect_low_bits<ufix<33, 0>>();
  expect_low_bits<ufix<63, 63>>();
}

template <class T>
void expect_magnitude() {
  for (const std::uint64_t bits : bits_of<T>()) {
    const Wide v = wrapped<T>(Wide(bits));
    const auto m = magnitude(from_raw<T>(bits));
    static_assert(!decltype(m)::kSigned && decltype(m)::kWidth == T::kWidth && decltype(m)::kInteger == T::kInteger);
    ASSERT_EQ(Wide(raw(m)), v < 0 ? -v : v);
  }
}
TEST(Arithmetic, MagnitudeOfTheMostNegativeOneFits) {
  expect_magnitude<fix<5, 2>>();
  expect_magnitude<fix<32, 32>>();
  expect_magnitude<fix<63, 20>>();
}

template <class T>
void expect_normalized() {
  for (const std::uint64_t bits : bits_of<T>()) {
    const T x = from_raw<T>(bits);
    const Wide v = wrapped<T>(Wide(bits));
    ASSERT_EQ(Wide(raw(shift_in(x, false))), wrapped<T>(2 * v));
    ASSERT_EQ(Wide(raw(shift_in(x, true))), wrapped<T>(2 * v + 1));
    if (v == 0) continue;
    const auto n = normalize(x);
    ASSERT_EQ(Wide(raw(n.number)), v << n.zeros);
    ASSERT_EQ(Wide(raw(n.number)) >> (T::kWidth - 1), 1);
  }
}
TEST(Arithmetic, NormalizesToTheTopBit) {
  expect_normalized<ufix<1, 1>>();
  expect_normalized<ufix<5, 3>>();
  expect_normalized<ufix<28, 20>>();
  expect_normalized<ufix<32, 32>>();
  expect_normalized<ufix<44, 28>>();
  expect_normalized<ufix<64, 1>>();
}

template <class T>
void expect_multiples() {
  for (const std::uint64_t bits : bits_of<T>()) {
    const T x = from_raw<T>(bits);
    ASSERT_EQ(raw(trimmed(x)), raw(x));
    for (int n = 0; n < 8; ++n) {
      const Wider<T, 3> got = multiple(x, n);
      ASSERT_EQ(Wide(raw(got)), Wide(raw(x)) * n) << bits << " * " << n;
    }
  }
}
TEST(Arithmetic, MultipliesByASmallNumberAndTrimsExactly) {
  expect_multiples<ufix<1, 1>>();
  expect_multiples<fix<20, 16>>();
  expect_multiples<ufix<29, 16>>();
  expect_multiples<fix<30, 8>>();
  expect_multiples<fix<61, 24>>();
}

template <class T, class A, class B>
void expect_modulo() {
  for (const std::uint64_t a : bits_of<A>()) {
    for (const std::uint64_t b : bits_of<B>()) {
      const T got = product_modulo<T>(from_raw<A>(a), from_raw<B>(b));
      ASSERT_EQ(Wide(raw(got)), wrapped<T>(wrapped<A>(Wide(a)) * wrapped<B>(Wide(b)))) << a << " * " << b;
    }
  }
}
TEST(Arithmetic, WrapsAProduct) {
  expect_modulo<fix<5, 2>, fix<4, 2>, ufix<3, 2>>();
  expect_modulo<ufix<7, 4>, fix<5, 3>, fix<4, 3>>();
  expect_modulo<fix<32, 15>, fix<33, 20>, fix<15, 11>>();
  expect_modulo<fix<63, 30>, fix<63, 38>, fix<29, 21>>();
  expect_modulo<ufix<64, 32>, ufix<64, 40>, ufix<40, 32>>();
}

template <class T, class X>
void expect_rounded_to() {
  const int places = X::kFraction - T::kFraction;
  for (const std::uint64_t bits : bits_of<X>()) {
    const Wide v = wrapped<X>(Wide(bits)), twice = v >> (places - 1);
    ASSERT_EQ(Wide(raw(round_to<T>(from_raw<X>(bits)))), wrapped<T>((twice + 1) >> 1)) << bits;
  }
}
TEST(Arithmetic, RoundsHalfUp) {
  expect_rounded_to<fix<4, 2>, fix<5, 2>>();
  expect_rounded_to<ufix<3, 3>, ufix<5, 2>>();
  expect_rounded_to<ufix<18, 0>, fix<33, 1>>();
  expect_rounded_to<ufix<17, 1>, ufix<63, 4>>();
}

template <class T, class A>
void expect_stepped() {
  for (const std::uint64_t x : bits_of<T>()) {
    for (const std::uint64_t a : bits_of<A>()) {
      const T got = stepped(from_raw<T>(x), from_raw<A>(a), 3, from_raw<A>(a / 3), 2);
      const Wide step = 3 * wrapped<A>(Wide(a)) + 2 * wrapped<A>(Wide(a / 3));
      ASSERT_EQ(Wide(raw(got)), wrapped<T>(wrapped<T>(Wide(x)) + step)) << x << ", " << a;
    }
  }
}
TEST(Arithmetic, StepsInAPlane) {
  expect_stepped<ufix<5, 2>, fix<5, 2>>();
  expect_stepped<ufix<22, 8>, fix<22, 8>>();
  expect_stepped<ufix<62, 20>, fix<61, 19>>();
}

// Products that are taken at once, and longer ones.
template <class T, class A, class B>
void expect_rounded() {
  for (const std::uint64_t a : bits_of<A>()) {
    for (const std::uint64_t b : bits_of<B>()) {
      const Wide twice = 2 * (wrapped<A>(Wide(a)) * wrapped<B>(Wide(b)));
      for (int n = 0; n < 64; ++n) {
        const T got = rounded_product<T>(from_raw<A>(a), from_raw<B>(b), n);
        ASSERT_EQ(Wide(raw(got)), wrapped<T>(((twice >> n) + 1) >> 1)) << a << " * " << b << " / 2^" << n;
      }
    }
  }
}
TEST(Arithmetic, RoundsAProductOnce) {
  expect_rounded<fix<5, 2>, fix<5, 5>, ufix<4, 1>>();
  expect_rounded<fix<33, 20>, fix<31, 26>, ufix<19, 1>>();
  expect_rounded<fix<26, 12>, fix<32, 20>, ufix<31, 1>>();
  expect_rounded<fix<40, 32>, fix<23, 20>, ufix<40, 1>>();
  expect_rounded<fix<47, 32>, fix<47, 40>, ufix<29, 1>>();
  expect_rounded<fix<63, 30>, fix<62, 40>, ufix<25, 1>>();
  expect_rounded<fix<63, 30>, fix<46, 40>, ufix<40, 1>>();
}

}  // namespace
}  // namespace halfspace::tests
