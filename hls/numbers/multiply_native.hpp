// SPDX-License-Identifier: Apache-2.0
// The product of native numbers of W1 and W2 bits, with a sign or without.
//
// Bambu builds a multiplier as wide as the integers are that it multiplies, unless it sees a mask. So there it is a
// product of natural numbers: a negative factor is 2^W more then, and so many times the other factor are taken off.
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
  using Natural = fixed_detail::Carrier<W1 + W2, false>;
  const Natural u = Natural(fixed_detail::wrap<W1, false>(a)), v = Natural(fixed_detail::wrap<W2, false>(b));
  return fixed_detail::wrap < W1 + W2, S1 || S2 > (u * v - (a < 0 ? v << W1 : 0) - (b < 0 ? u << W2 : 0));
#else
  return Product(a) * Product(b);
#endif
}

}  // namespace native
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_MULTIPLY_NATIVE_HPP_
