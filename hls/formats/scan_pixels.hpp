// SPDX-License-Identifier: Apache-2.0
// What units do that take the pixels of a stamp one after the other: the next lane that shows a triangle.
#ifndef HALFSPACE_HLS_FORMATS_SCAN_PIXELS_HPP_
#define HALFSPACE_HLS_FORMATS_SCAN_PIXELS_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// The first lane from `from` on that shows a triangle; F::kLanes if there is none.
template <class F>
int covered_lane(const Scan<F>& in, int from) {
  int first = F::kLanes;
Lanes:
  for (int l = F::kLanes - 1; l >= 0; --l) {
    HS_UNROLL
    if (l >= from && is_set(in.index[l])) first = l;
  }
  return first;
}

// A pixel of the frame.
struct PixelPlace {
  int x, y;
};
template <class F>
PixelPlace lane_place(const Scan<F>& in, int lane) {
  const int x = int(raw(in.x)), y = int(raw(in.y));
  return {(x << F::kLog2LanesX) + (lane & (F::kLanesX - 1)), (y << F::kLog2LanesY) + (lane >> F::kLog2LanesX)};
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_SCAN_PIXELS_HPP_
