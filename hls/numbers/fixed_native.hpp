// SPDX-License-Identifier: Apache-2.0
// fixed.hpp on C++ alone: the bits in the smallest of int32_t, uint32_t, int64_t, uint64_t that holds them.
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_NATIVE_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_NATIVE_HPP_

#include "hls/numbers/fixed_rules.hpp"
#include "hls/numbers/multiply_native.hpp"

namespace halfspace {
namespace native {

// v · 2^Shift: exact or wrapping to the left, floor to the right.
template <int Shift, class T, typename std::enable_if<(Shift >= 0), int>::type = 0>
constexpr T scale(T v) {
  return T(typename std::make_unsigned<T>::type(v) << Shift);
}
template <int Shift, class T, typename std::enable_if<(Shift < 0), int>::type = 0>
constexpr T scale(T v) {
  return T(v >> -Shift);
}

template <int W, int I, bool S>
struct Fixed {
  static_assert(W >= 1 && W <= 64, "a fixed-point value has 1 to 64 bits: split the product, or narrow the format");
  static_assert(I >= 0 && I <= W, "the binary point lies inside the word");
  static constexpr int kWidth = W;
  static constexpr int kInteger = I;
  static constexpr int kFraction = W - I;
  static constexpr bool kSigned = S;
  using Carrier = fixed_detail::Carrier<W, S>;
  // Of the same kind.
  template <int W2, int I2, bool S2>
  using Other = Fixed<W2, I2, S2>;
  template <int More>
  using Wider = Fixed<W + More, I + More, S>;
  using Whole = Fixed<I, I, S>;
  template <class X>
  using Refined = Fixed<I + X::kFraction, I, S>;
  using Unsigned = Fixed<W, I, false>;

  // For kernels, whose formats may be chosen at run time in a simulation.
  static constexpr int width() { return W; }
  static constexpr int fraction() { return W - I; }

  Carrier bits;

  Fixed() = default;
  // Written out, so that a record is copied field by field: a processor that copies fields it has just written as one
  // wide word waits for them to reach its cache.
  constexpr Fixed(const Fixed& other) : bits(other.bits) {}
  Fixed& operator=(const Fixed& other) {
    bits = other.bits;
    return *this;
  }

  template <int W2, int I2, bool S2>
  constexpr Fixed(const Fixed<W2, I2, S2>& other) : bits(convert(other)) {}

  template <class Int>
  static constexpr Fixed from_bits(Int bits) {
    Fixed x{};
    x.bits = fixed_detail::wrap<W, S>(bits);
    return x;
  }
  // a·b, wrapped.
  template <class A, class B>
  static constexpr Fixed from_product(const A& a, const B& b) {
    static_assert(kFraction == A::kFraction + B::kFraction, "the last place of the product is that of the result");
    return from_bits(multiply_modulo<W, A::kWidth, A::kSigned, B::kWidth, B::kSigned>(a.bits, b.bits));
  }

 private:
  template <int W2, int I2, bool S2>
  static constexpr Carrier convert(const Fixed<W2, I2, S2>& other) {
    constexpr int kShift = (W - I) - (W2 - I2);
    // Lossless when no integer bit is dropped and no sign is lost.
    constexpr bool kFits = I - int(S) >= I2 - int(S2) && (S || !S2);
    using Work = fixed_detail::Carrier<fixed_detail::max(W, W2), S2>;
    return kFits ? Carrier(scale<kShift>(Work(other.bits))) : fixed_detail::wrap<W, S>(scale<kShift>(Work(other.bits)));
  }
};

template <int W, int I, bool S>
constexpr typename Fixed<W, I, S>::Carrier raw(const Fixed<W, I, S>& x) {
  return x.bits;
}

template <class A, class B, bool S>
using Sum = Fixed<fixed_detail::Sum<A, B>::kWidth, fixed_detail::Sum<A, B>::kInteger, S>;

// x on the grid of T, which holds it exactly but for the sign bit that the operation may still need.
template <class T, class X>
constexpr typename T::Carrier align(const X& x) {
  return scale<T::kFraction - X::kFraction>(typename T::Carrier(x.bits));
}

#define HS_FIXED_TEMPLATE template <int W1, int I1, bool S1, int W2, int I2, bool S2>
#define HS_FIXED_OPERANDS const Fixed<W1, I1, S1>&a, const Fixed<W2, I2, S2>&b
#define HS_FIXED_SUM(sign) Sum<Fixed<W1, I1, S1>, Fixed<W2, I2, S2>, sign>

HS_FIXED_TEMPLATE constexpr HS_FIXED_SUM(S1 || S2) operator+(HS_FIXED_OPERANDS) {
  using T = HS_FIXED_SUM(S1 || S2);
  T sum{};
  sum.bits = align<T>(a) + align<T>(b);
  return sum;
}
HS_FIXED_TEMPLATE constexpr HS_FIXED_SUM(true) operator-(HS_FIXED_OPERANDS) {
  using T = HS_FIXED_SUM(true);
  T difference{};
  difference.bits = align<T>(a) - align<T>(b);
  return difference;
}
HS_FIXED_TEMPLATE constexpr Fixed<W1 + W2, I1 + I2, S1 || S2> operator*(HS_FIXED_OPERANDS) {
  using T = Fixed<W1 + W2, I1 + I2, S1 || S2>;
  T product{};
  product.bits = multiply<W1, S1, W2, S2>(a.bits, b.bits);
  return product;
}
#define HS_FIXED_COMPARE(op)                                                       \
  HS_FIXED_TEMPLATE constexpr bool operator op(HS_FIXED_OPERANDS) {                \
    static_assert(S1 == S2, "compare signed with signed, unsigned with unsigned"); \
    using T = HS_FIXED_SUM(S1 || S2);                                              \
    return align<T>(a) op align<T>(b);                                             \
  }                                                                                \
  template <int W, int I, bool S>                                                  \
  constexpr bool operator op(const Fixed<W, I, S>& a, const Fixed<W, I, S>& b) {   \
    return a.bits op b.bits;                                                       \
  }
HS_FIXED_COMPARE(<)
HS_FIXED_COMPARE(<=)
HS_FIXED_COMPARE(>)
HS_FIXED_COMPARE(>=)
HS_FIXED_COMPARE(==)
HS_FIXED_COMPARE(!=)
#undef HS_FIXED_COMPARE
#undef HS_FIXED_SUM
#undef HS_FIXED_OPERANDS
#undef HS_FIXED_TEMPLATE

template <int W, int I>
constexpr Fixed<W + 1, I + 1, true> operator-(const Fixed<W, I, true>& a) {
  using T = Fixed<W + 1, I + 1, true>;
  T negative{};
  negative.bits = -typename T::Carrier(a.bits);
  return negative;
}

// Of the carriers: of two objects, a compiler branches.
template <int W, int I, bool S>
constexpr Fixed<W, I, S> select(bool which, const Fixed<W, I, S>& a, const Fixed<W, I, S>& b) {
  Fixed<W, I, S> result{};
  result.bits = which ? a.bits : b.bits;
  return result;
}
template <int W, int I, bool S>
constexpr Fixed<W + 3, I + 3, S> multiple(const Fixed<W, I, S>& x, int n) {
  using T = Fixed<W + 3, I + 3, S>;
  T result{};
  result.bits = typename T::Carrier(x.bits) * typename T::Carrier(n);
  return result;
}
template <int W, int I, bool S>
constexpr Fixed<W, I, S> shift_left(const Fixed<W, I, S>& x, int n) {
  return Fixed<W, I, S>::from_bits(std::uint64_t(x.bits) << n);
}
template <int W, int I, bool S>
constexpr Fixed<W, I, S> shift_right(const Fixed<W, I, S>& x, int n) {
  Fixed<W, I, S> result{};
  result.bits = typename Fixed<W, I, S>::Carrier(fixed_detail::Carrier<64, S>(x.bits) >> n);
  return result;
}

}  // namespace native
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_NATIVE_HPP_
