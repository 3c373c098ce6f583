// SPDX-License-Identifier: Apache-2.0
// What kernels do with numbers beside + - * and comparisons. The width of every result is in a type:
//
//   is_zero(x), is_negative(x)
//   trimmed(x)                 x; of one from a memory, a tool does not see that its carrier holds no more bits
//   select(which, a, b)        a, or b if not `which`; of one type
//   magnitude(x)               |x|, without a sign and as wide as x
//   shift_left(x, n)           x·2^n of x's type, wrapped; n is 0 … 63
//   shift_right(x, n)          x·2^−n of x's type, truncated; n is 0 … 63
//   shift_in(x, bit)           x·2 of x's type, wrapped, with `bit` in its last place; x has no sign
//   slice<T>(x, from)          the bits of x from place `from` on as those of T, wrapped; `from` lies inside x
//   leading<T>(x)              the bits of T from the top bit of x down, with 0 behind if x has fewer; T has no sign
//   low_bits(x, n)             the last n bits of x; x has no sign
//   merged(a, b)               the bits of a or b, where one of them is 0; of one type
//   normalize(x)               x·2^zeros with its top bit set, and zeros; x has no sign; of 0, some zeros
//   multiple(x, n)             n·x, exact, of a type with three bits more before the point; n is 0 … 7
//   round_to<T>(x)             x, half up to the last place of T and wrapped; x has places behind it, and one bit less
//                              than a number may have
//   stepped(x, a, m, b, n)     x + a·m + b·n of x's type, wrapped; a and b have its last place
//   product_modulo<T>(a, b)    a·b, its last place that of T, wrapped; of a product that may be longer than 64 bits
//   rounded_product<T>(a, b, n)   floor(a·b·2^−n + ½) of the bits, wrapped to those of T; n is 0 … 63, b has no sign
//                              and 40 bits at most, and the product may be longer than 64 bits
//
// Wider<T, n> is T with n more bits before the point, Whole<T> is T without those behind it; Refined<T, X> has those of
// T before it and those of X behind it.
#ifndef HALFSPACE_HLS_NUMBERS_ARITHMETIC_HPP_
#define HALFSPACE_HLS_NUMBERS_ARITHMETIC_HPP_

#include "hls/numbers/fixed.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

template <class T, int More>
using Wider = typename T::template Wider<More>;
template <class T>
using Whole = typename T::Whole;
template <class T, class X>
using Refined = typename T::template Refined<X>;

template <class T>
constexpr bool is_zero(const T& x) {
  return raw(x) == 0;
}
template <class T>
constexpr bool is_negative(const T& x) {
  return T::kSigned && std::int64_t(raw(x)) < 0;
}

template <class T>
constexpr T trimmed(const T& x) {
  return from_raw<T>(raw(x));
}

template <class T, class X>
constexpr T slice(const X& x, int from) {
  return from_raw<T>(raw(x) >> from);
}

template <class T, class X>
constexpr T leading(const X& x) {
  const int more = X::width() - T::width();
  return more >= 0 ? slice<T>(x, more) : shift_left(slice<T>(x, 0), -more);
}
template <class T>
constexpr T low_bits(const T& x, int n) {
  return from_raw<T>(raw(x) & raw(T(shift_left(from_raw<T>(1), n) - from_raw<T>(1))));
}
template <class T>
constexpr T merged(const T& a, const T& b) {
  return from_raw<T>(raw(a) | raw(b));
}

template <class T>
constexpr T shift_in(const T& x, bool bit) {
  return from_raw<T>(std::uint64_t(raw(x)) << 1 | std::uint64_t(bit));
}

template <class T>
constexpr typename T::Unsigned magnitude(const T& x) {
  using U = typename T::Unsigned;
  return select(is_negative(x), U(-x), U(x));
}

template <class T, class X>
constexpr T round_to(const X& x) {
  return x + from_raw<X>(std::uint64_t(1) << (x.fraction() - T::fraction() - 1));
}

template <class T, class A, class B>
constexpr T stepped(const T& x, const A& a, int m, const B& b, int n) {
  using U = typename T::Unsigned::Carrier;
  return from_raw<T>(U(U(raw(x)) + U(raw(a)) * U(m) + U(raw(b)) * U(n)));
}
template <class T, class A, class B>
constexpr T product_modulo(const A& a, const B& b) {
  return T::from_product(a, b);
}

template <class T>
struct Normalized {
  T number;
  int zeros;
};
// By halves of the word.
template <class T>
Normalized<T> normalize(const T& x) {
  Normalized<T> result = {x, 0};
Halves:
  for (int step = 32; step > 0; step /= 2) {
    HS_UNROLL
    if (step < T::width()) {
      const bool shifts = is_zero(shift_right(result.number, T::width() - step));
      result.number = select(shifts, shift_left(result.number, step), result.number);
      result.zeros += shifts ? step : 0;
    }
  }
  return result;
}

namespace arithmetic_detail {

template <class T, int W, bool S>
using Integer = typename T::template Other<W, W, S>;

// floor(p·2^−n + ½) = floor((floor(2p·2^−n) + 1) / 2): no half of n places has to be made.
template <class T, class Q>
constexpr T rounded(const Q& twice) {
  using Bits = Integer<Q, T::kWidth, false>;
  using Bit = Integer<Q, 1, false>;
  return slice<T>(Bits(slice<Bits>(twice, 1) + slice<Bit>(twice, 0)), 0);
}

template <class T, class A, class B>
constexpr T rounded_product(const A& a, const B& b, int n, std::true_type) {
  using Product = Integer<A, A::kWidth + B::kWidth + 1, true>;
  const Product twice = shift_left(slice<Product>(a * b, 0), 1);
  return rounded<T>(slice<Integer<A, T::kWidth + 1, false>>(shift_right(twice, n), 0));
}

// a = H·2^24 + L and t = L·b: the product is (H·b + floor(t / 2^24))·2^24 + t mod 2^24.
template <class T, class A, class B>
constexpr T rounded_product(const A& a, const B& b, int n, std::false_type) {
  constexpr int kCut = 24;
  using Low = Integer<A, kCut, false>;
  using High = Integer<A, (A::kWidth > kCut ? A::kWidth - kCut : 1), true>;
  using Factor = Integer<A, B::kWidth, false>;
  using Sum = Integer<A, High::kWidth + B::kWidth, true>;  // |a·b| < 2^(widths − 1)
  using Twice = Integer<A, T::kWidth + 1, false>;
  const Factor factor = slice<Factor>(b, 0);
  const auto low = slice<Low>(a, 0) * factor;
  const High top = slice<High>(a, A::kWidth > kCut ? kCut : A::kWidth - 1);
  const Sum high = top * factor + slice<Factor>(low, kCut);
  const Low rest = slice<Low>(low, 0);
  if (n > kCut) return rounded<T>(slice<Twice>(shift_right(high, n - kCut - 1), 0));
  const Integer<A, kCut + 1, false> twice_rest = shift_in(Integer<A, kCut + 1, false>(rest), false);
  const Twice above = shift_left(slice<Twice>(high, 0), kCut + 1 - n);
  return rounded<T>(from_raw<Twice>(raw(above) | raw(shift_right(twice_rest, n))));
}

}  // namespace arithmetic_detail

template <class T, class A, class B, int W = A::kWidth + B::kWidth + 1>
constexpr T rounded_product(const A& a, const B& b, int n) {
  return arithmetic_detail::rounded_product<T>(a, b, n, std::integral_constant<bool, (W <= 64)>());
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_ARITHMETIC_HPP_
