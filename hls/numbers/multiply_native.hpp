// SPDX-License-Identifier: Apache-2.0
// Products of native numbers of W1 and W2 bits, with a sign or without: all of one, and the last W bits of one that may
// be longer than 64 bits.
//
// Bambu builds a multiplier as wide as the integers are that it multiplies, unless it sees a mask. So there factors are
// masked: a number with a sign is its bits below the sign, less 2^(W−1) where it is negative. And a factor of more than
// 16 bits is cut in two where the last bits are asked for, as a multiplier of 16 bits is one block of an FPGA, one of
// 32 three and a longer one ten; one of 8 is none, but LUTs.
#ifndef HALFSPACE_HLS_NUMBERS_MULTIPLY_NATIVE_HPP_
#define HALFSPACE_HLS_NUMBERS_MULTIPLY_NATIVE_HPP_

#include "hls/numbers/fixed_rules.hpp"

namespace halfspace {
namespace native {

template <int W1, bool S1, int W2, bool S2>
constexpr fixed_detail::Carrier<W1 + W2, S1 || S2> multiply(fixed_detail::Carrier<W1, S1> a,
                                                            fixed_detail::Carrier<W2, S2> b) {
  using Product = fixed_detail::Carrier<W1 + W2, S1 || S2>;
#ifdef __BAMBU__
  constexpr int kLow1 = W1 - int(S1), kLow2 = W2 - int(S2);
  using U = fixed_detail::Carrier<W1 + W2, false>;
  const U u = U(fixed_detail::wrap<kLow1, false>(a)), v = U(fixed_detail::wrap<kLow2, false>(b));
  return fixed_detail::wrap < W1 + W2, S1 || S2 > (u * v - (b < 0 ? u << kLow2 : 0) - (a < 0 ? U(b) << kLow1 : 0));
#else
  return Product(a) * Product(b);
#endif
}

#ifdef __BAMBU__
// The last W bits of a product, of factors without a sign. Of a few more than 8, those above 8 are made of their own.
template <int W>
constexpr fixed_detail::Carrier<W, false> multiply_last(fixed_detail::Carrier<W, false> u,
                                                        fixed_detail::Carrier<W, false> v) {
  constexpr bool kCuts = W > 8 && W <= 12;
  constexpr int kCut = kCuts ? 8 : W, kRest = kCuts ? W - kCut : 1;
  const auto low = fixed_detail::wrap<kCut, false>(u) * fixed_detail::wrap<kCut, false>(v);
  if (!kCuts) return low;
  const auto rest = fixed_detail::wrap<kRest, false>(u >> kCut) * fixed_detail::wrap<kRest, false>(v) +
                    fixed_detail::wrap<kRest, false>(u) * fixed_detail::wrap<kRest, false>(v >> kCut);
  return low + (rest << kCut);
}
#endif

template <int W, int W1, bool S1, int W2, bool S2>
constexpr fixed_detail::Carrier<W, false> multiply_modulo(fixed_detail::Carrier<W1, S1> a,
                                                          fixed_detail::Carrier<W2, S2> b) {
  using U = fixed_detail::Carrier<W, false>;
#ifdef __BAMBU__
  // The parts of a product that is too long are not made.
  constexpr bool kLong = W1 + W2 > 63, kCuts = !kLong && W1 > 16 && W > 16;
  constexpr int kWidth1 = kLong ? 1 : W1, kWidth2 = kLong ? 1 : W2, kLow = kCuts ? 16 : 1, kHigh = kCuts ? W - kLow : 1;
  if (kLong) return U(a) * U(b);
  if (!kCuts) return U(multiply<kWidth1, S1, kWidth2, S2>(a, b));
  // a = high·2^16 + low, and of high·b the last bits are asked for.
  const auto low = multiply<kLow, false, kWidth2, S2>(fixed_detail::wrap<kLow, false>(a), b);
  return U(low) + (U(multiply_last<kHigh>(a >> kLow, b)) << kLow);
#else
  return U(a) * U(b);
#endif
}

}  // namespace native
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_MULTIPLY_NATIVE_HPP_
