// SPDX-License-Identifier: Apache-2.0
// fixed.hpp on the numbers of a library: a number is one of the library's, and the library does the arithmetic.
//
// A Library gives
//   Number<W, I, S>                 its number, that truncates toward minus infinity and wraps
//   bits<W, I, S>(x)                the bits of a number in an integer of 64 bits; those above W mean nothing
//   set_bits<W, I, S>(x, bits)      the inverse, of an integer that was wrapped to W bits
//   natural<W, I, S>(result)        takes what an operator gave; of a library that has types for results, only the one
//                                   of the width that fixed.hpp promises
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_LIBRARY_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_LIBRARY_HPP_

#include "hls/numbers/fixed_rules.hpp"

namespace halfspace {

template <class Library, int W, int I, bool S>
struct LibraryFixed {
  static_assert(W >= 1 && W <= 64, "a fixed-point value has 1 to 64 bits: split the product, or narrow the format");
  static_assert(I >= 0 && I <= W, "the binary point lies inside the word");
  static constexpr int kWidth = W;
  static constexpr int kInteger = I;
  static constexpr int kFraction = W - I;
  static constexpr bool kSigned = S;
  using Carrier = fixed_detail::Carrier<W, S>;
  using Number = typename Library::template Number<W, I, S>;

  // Of the same kind.
  template <int W2, int I2, bool S2>
  using Other = LibraryFixed<Library, W2, I2, S2>;
  template <int More>
  using Wider = LibraryFixed<Library, W + More, I + More, S>;
  using Whole = LibraryFixed<Library, I, I, S>;
  template <class X>
  using Refined = LibraryFixed<Library, I + X::kFraction, I, S>;
  using Unsigned = LibraryFixed<Library, W, I, false>;

  static constexpr int width() { return W; }
  static constexpr int fraction() { return W - I; }

  Number number;

  LibraryFixed() : number(0) {}
  template <int W2, int I2, bool S2>
  LibraryFixed(const LibraryFixed<Library, W2, I2, S2>& other) : number(other.number) {}

  template <class Int>
  static LibraryFixed from_bits(Int bits) {
    LibraryFixed x;
    Library::template set_bits<W, I, S>(x.number, fixed_detail::wrap<W, S>(bits));
    return x;
  }
  template <class Result>
  static LibraryFixed from_result(const Result& result) {
    LibraryFixed x;
    x.number = Library::template natural<W, I, S>(result);
    return x;
  }
  // a·b, wrapped.
  template <class A, class B>
  static LibraryFixed from_product(const A& a, const B& b) {
    static_assert(kFraction == A::kFraction + B::kFraction, "the last place of the product is that of the result");
    LibraryFixed x;
    x.number = a.number * b.number;
    return x;
  }
};

template <class L, int W, int I, bool S>
typename LibraryFixed<L, W, I, S>::Carrier raw(const LibraryFixed<L, W, I, S>& x) {
  return fixed_detail::wrap<W, S>(L::template bits<W, I, S>(x.number));
}

template <class A, class B, bool S, class L>
using LibrarySum = LibraryFixed<L, fixed_detail::Sum<A, B>::kWidth, fixed_detail::Sum<A, B>::kInteger, S>;

#define HS_FIXED_TEMPLATE template <class L, int W1, int I1, bool S1, int W2, int I2, bool S2>
#define HS_FIXED_OPERANDS const LibraryFixed<L, W1, I1, S1>&a, const LibraryFixed<L, W2, I2, S2>&b
#define HS_FIXED_SUM(sign) LibrarySum<LibraryFixed<L, W1, I1, S1>, LibraryFixed<L, W2, I2, S2>, sign, L>

HS_FIXED_TEMPLATE HS_FIXED_SUM(S1 || S2) operator+(HS_FIXED_OPERANDS) {
  return HS_FIXED_SUM(S1 || S2)::from_result(a.number + b.number);
}
HS_FIXED_TEMPLATE HS_FIXED_SUM(true) operator-(HS_FIXED_OPERANDS) {
  return HS_FIXED_SUM(true)::from_result(a.number - b.number);
}
HS_FIXED_TEMPLATE LibraryFixed<L, W1 + W2, I1 + I2, S1 || S2> operator*(HS_FIXED_OPERANDS) {
  return LibraryFixed < L, W1 + W2, I1 + I2, S1 || S2 > ::from_result(a.number * b.number);
}
#define HS_FIXED_COMPARE(op)                                                       \
  HS_FIXED_TEMPLATE bool operator op(HS_FIXED_OPERANDS) {                          \
    static_assert(S1 == S2, "compare signed with signed, unsigned with unsigned"); \
    return a.number op b.number;                                                   \
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

template <class L, int W, int I>
LibraryFixed<L, W + 1, I + 1, true> operator-(const LibraryFixed<L, W, I, true>& a) {
  return LibraryFixed<L, W + 1, I + 1, true>::from_result(-a.number);
}

template <class L, int W, int I, bool S>
LibraryFixed<L, W, I, S> select(bool which, const LibraryFixed<L, W, I, S>& a, const LibraryFixed<L, W, I, S>& b) {
  return which ? a : b;
}
template <class L, int W, int I, bool S>
LibraryFixed<L, W + 3, I + 3, S> multiple(const LibraryFixed<L, W, I, S>& x, int n) {
  return x * LibraryFixed<L, 3, 3, false>::from_bits(n);
}
template <class L, int W, int I, bool S>
LibraryFixed<L, W, I, S> shift_left(const LibraryFixed<L, W, I, S>& x, int n) {
  return LibraryFixed<L, W, I, S>::from_result(x.number << n);
}
template <class L, int W, int I, bool S>
LibraryFixed<L, W, I, S> shift_right(const LibraryFixed<L, W, I, S>& x, int n) {
  return LibraryFixed<L, W, I, S>::from_result(x.number >> n);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_LIBRARY_HPP_
