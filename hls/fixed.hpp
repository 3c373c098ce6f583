// SPDX-License-Identifier: Apache-2.0
// Fixed-point numbers: the only arithmetic that kernels see.
//
//   fix<W, I>, ufix<W, I>   W bits in all, I of them before the binary point; two's complement or unsigned.
//   raw(x)                  the bits as an integer; the value is raw(x) · 2^(I − W)
//   from_raw<T>(bits)       the inverse; bits beyond T's width are dropped
//   + - * unary- compare    exact: the result is as wide as it has to be
//   T(x), T y = x           quantization: truncate toward minus infinity; overflow: wrap. The only modes there are:
//                           rounding is a half added beforehand, and no kernel saturates.
//
// The rules for the widths of results are those of Vitis ap_fixed and Catapult ac_fixed, so that a back end may map
// fix<W, I> to ap_fixed<W, I, AP_TRN, AP_WRAP> or ac_fixed<W, I, true, AC_TRN, AC_WRAP>. This back end keeps the
// bits in the smallest of int32_t, uint32_t, int64_t, uint64_t that holds them. No value is wider than 64 bits.
#ifndef HALFSPACE_HLS_FIXED_HPP_
#define HALFSPACE_HLS_FIXED_HPP_

#include <cstdint>
#include <type_traits>

namespace halfspace {
namespace fixed_detail {

constexpr int max(int a, int b) { return a > b ? a : b; }

template <int W, bool S>
using Carrier = typename std::conditional<
    (W <= 32), typename std::conditional<S, std::int32_t, std::uint32_t>::type,
    typename std::conditional<S, std::int64_t, std::uint64_t>::type>::type;

// Keeps the low W bits of v and extends them to the carrier.
template <int W, bool S, class T>
constexpr Carrier<W, S> wrap(T v) {
  using C = Carrier<W, S>;
  using U = Carrier<W, false>;
  constexpr int kSpare = int(sizeof(C)) * 8 - W;
  return S ? C(C(U(U(v) << kSpare)) >> kSpare) : C(U(U(v) << kSpare) >> kSpare);
}

// v · 2^Shift: exact or wrapping to the left, floor to the right.
template <int Shift, class T, typename std::enable_if<(Shift >= 0), int>::type = 0>
constexpr T scale(T v) {
  return T(typename std::make_unsigned<T>::type(v) << Shift);
}
template <int Shift, class T, typename std::enable_if<(Shift < 0), int>::type = 0>
constexpr T scale(T v) {
  return T(v >> -Shift);
}

}  // namespace fixed_detail

template <int W, int I, bool S>
struct Fixed {
  static_assert(W >= 1 && W <= 64, "a fixed-point value has 1 to 64 bits: split the product, or narrow the format");
  static_assert(I >= 0 && I <= W, "the binary point lies inside the word");
  static constexpr int kWidth = W;
  static constexpr int kInteger = I;
  static constexpr int kFraction = W - I;
  static constexpr bool kSigned = S;
  using Carrier = fixed_detail::Carrier<W, S>;

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

 private:
  template <int W2, int I2, bool S2>
  static constexpr Carrier convert(const Fixed<W2, I2, S2>& other) {
    constexpr int kShift = (W - I) - (W2 - I2);
    // Lossless when no integer bit is dropped and no sign is lost.
    constexpr bool kFits = I - int(S) >= I2 - int(S2) && (S || !S2);
    using Work = fixed_detail::Carrier<fixed_detail::max(W, W2), S2>;
    return kFits ? Carrier(fixed_detail::scale<kShift>(Work(other.bits)))
                 : fixed_detail::wrap<W, S>(fixed_detail::scale<kShift>(Work(other.bits)));
  }
};

template <int W, int I>
using fix = Fixed<W, I, true>;
template <int W, int I>
using ufix = Fixed<W, I, false>;

template <int W, int I, bool S>
constexpr typename Fixed<W, I, S>::Carrier raw(const Fixed<W, I, S>& x) {
  return x.bits;
}

template <class T, class Int>
constexpr T from_raw(Int bits) {
  return T::from_bits(bits);
}

namespace fixed_detail {

template <class A, class B>
struct Sum {
  static constexpr bool kSigned = A::kSigned || B::kSigned;
  static constexpr int kInteger = 1 + max(A::kInteger + int(B::kSigned && !A::kSigned),
                                          B::kInteger + int(A::kSigned && !B::kSigned));
  static constexpr int kFraction = max(A::kFraction, B::kFraction);
  template <bool S>
  using Type = Fixed<kInteger + kFraction, kInteger, S>;
};

// x on the grid of T, which holds it exactly but for the sign bit that the operation may still need.
template <class T, class X>
constexpr typename T::Carrier align(const X& x) {
  return scale<T::kFraction - X::kFraction>(typename T::Carrier(x.bits));
}

}  // namespace fixed_detail

#define HS_FIXED_TEMPLATE template <int W1, int I1, bool S1, int W2, int I2, bool S2>
#define HS_FIXED_OPERANDS const Fixed<W1, I1, S1>&a, const Fixed<W2, I2, S2>&b
#define HS_FIXED_SUM fixed_detail::Sum<Fixed<W1, I1, S1>, Fixed<W2, I2, S2>>

HS_FIXED_TEMPLATE constexpr typename HS_FIXED_SUM::template Type<S1 || S2> operator+(HS_FIXED_OPERANDS) {
  using T = typename HS_FIXED_SUM::template Type<S1 || S2>;
  T sum{};
  sum.bits = fixed_detail::align<T>(a) + fixed_detail::align<T>(b);
  return sum;
}
HS_FIXED_TEMPLATE constexpr typename HS_FIXED_SUM::template Type<true> operator-(HS_FIXED_OPERANDS) {
  using T = typename HS_FIXED_SUM::template Type<true>;
  T difference{};
  difference.bits = fixed_detail::align<T>(a) - fixed_detail::align<T>(b);
  return difference;
}
HS_FIXED_TEMPLATE constexpr Fixed<W1 + W2, I1 + I2, S1 || S2> operator*(HS_FIXED_OPERANDS) {
  using T = Fixed<W1 + W2, I1 + I2, S1 || S2>;
  T product{};
  product.bits = typename T::Carrier(a.bits) * typename T::Carrier(b.bits);
  return product;
}
#define HS_FIXED_COMPARE(op)                                                       \
  HS_FIXED_TEMPLATE constexpr bool operator op(HS_FIXED_OPERANDS) {                \
    static_assert(S1 == S2, "compare signed with signed, unsigned with unsigned"); \
    using T = typename HS_FIXED_SUM::template Type<S1 || S2>;                      \
    return fixed_detail::align<T>(a) op fixed_detail::align<T>(b);                 \
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
constexpr fix<W + 1, I + 1> operator-(const fix<W, I>& a) {
  fix<W + 1, I + 1> negative{};
  negative.bits = -typename fix<W + 1, I + 1>::Carrier(a.bits);
  return negative;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FIXED_HPP_
