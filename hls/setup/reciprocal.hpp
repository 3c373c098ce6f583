// SPDX-License-Identifier: Apache-2.0
// The one reciprocal of a triangle.
//
//   s = floor(log2 D),  R = floor(2^(r+s) / D + ½),  D >= 1 in units of the last place of F::Area
//
// Restoring division, a quotient bit an iteration: r + 2 of them, the last for the rounding.
#ifndef HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_
#define HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

template <class F>
struct AreaReciprocal {
  typename F::Shift shift;            // s
  typename F::Reciprocal reciprocal;  // R · 2^−r
};

template <class F>
AreaReciprocal<F> area_reciprocal(const typename F::Area& area) {
  const int top = F::Area::width() - 1;
  // Normalize: the leading one moves to bit 2c − 1, by halves of the word.
  std::uint64_t divisor = raw(area);
  int shift = top;
Normalize:
  for (int step = 32; step > 0; step /= 2) {
    HS_UNROLL
    if (step <= top && divisor >> (top + 1 - step) == 0) {
      divisor <<= step;
      shift -= step;
    }
  }

  // remainder < 2·divisor <= 2^(2c+1) throughout.
  std::uint64_t remainder = std::uint64_t(1) << top;
  std::uint64_t quotient = 0;
Divide:
  for (int i = 0; i < F::kReciprocalFraction + 2; ++i) {
    HS_PIPELINE(1)
    const bool one = remainder >= divisor;
    quotient = quotient << 1 | std::uint64_t(one);
    remainder = (one ? remainder - divisor : remainder) << 1;
  }

  AreaReciprocal<F> result;
  result.shift = from_raw<typename F::Shift>(shift);
  result.reciprocal = from_raw<typename F::Reciprocal>((quotient + 1) >> 1);
  return result;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_RECIPROCAL_HPP_
