// SPDX-License-Identifier: Apache-2.0
// The one reciprocal of a triangle.
//
//   s = floor(log2 D),  R = floor(2^(r+s) / D + ½),  D >= 1 in units of the last place of F::Area
//
// Restoring division, a quotient bit an iteration: r + 1 of them, and one for the rounding.
#ifndef HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_
#define HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

template <class F>
struct AreaReciprocal {
  typename F::Shift shift;            // s
  typename F::Reciprocal reciprocal;  // R · 2^−r
};

template <class F>
AreaReciprocal<F> area_reciprocal(const typename F::Area& area) {
  using Area = typename F::Area;
  using Reciprocal = typename F::Reciprocal;
  using Remainder = Wider<Area, 1>;
  const Normalized<Area> divisor = normalize(area);

  // remainder < 2·divisor <= 2^(2c+1) throughout.
  Remainder remainder = shift_left(from_raw<Remainder>(1), Area::width() - 1);
  Reciprocal quotient{};
Divide:
  for (int i = 0; i < F::kReciprocalFraction + 1; ++i) {
    HS_PIPELINE(1)
    const bool one = remainder >= divisor.number;
    const Area rest = select(one, remainder - divisor.number, remainder - Area());
    quotient = shift_in(quotient, one);
    remainder = rest + rest;
  }
  const bool up = remainder >= divisor.number;

  AreaReciprocal<F> result;
  result.shift = from_raw<typename F::Shift>(Area::width() - 1 - divisor.zeros);
  result.reciprocal = quotient + from_raw<Reciprocal>(up);
  return result;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_
