// SPDX-License-Identifier: Apache-2.0
// The one reciprocal of a triangle.
//
//   s = floor(log2 D),  R = floor(2^(r+s) / D + ½),  D >= 1 in units of the last place of F::Area
//
// Restoring division, two quotient bits a turn: r + 1 of them, and one for the rounding.
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

// A bit of the quotient, and what is left: remainder < 2·divisor <= 2^(2c+1) throughout.
template <class F>
struct Quotient {
  Wider<typename F::Area, 1> remainder;
  typename F::Reciprocal quotient;
};
template <class F>
Quotient<F> divide(const Quotient<F>& before, const typename F::Area& divisor) {
  using Area = typename F::Area;
  const bool one = before.remainder >= divisor;
  const Area rest = select(one, before.remainder - divisor, before.remainder - Area());
  Quotient<F> after;
  after.quotient = shift_in(before.quotient, one);
  after.remainder = rest + rest;
  return after;
}

template <class F>
AreaReciprocal<F> area_reciprocal(const typename F::Area& area) {
  using Area = typename F::Area;
  const Normalized<Area> divisor = normalize(area);

  Quotient<F> q;
  q.remainder = shift_left(from_raw<Wider<Area, 1>>(1), Area::width() - 1);
  q.quotient = typename F::Reciprocal();
  const int bits = F::kReciprocalFraction + 1;
  if (bits & 1) q = divide(q, divisor.number);
Divide:
  for (int i = 0; i < bits >> 1; ++i) {
    HS_PIPELINE(1)
    q = divide(divide(q, divisor.number), divisor.number);
  }
  const bool up = q.remainder >= divisor.number;

  AreaReciprocal<F> result;
  result.shift = from_raw<typename F::Shift>(Area::width() - 1 - divisor.zeros);
  result.reciprocal = q.quotient + from_raw<typename F::Reciprocal>(up);
  return result;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_
