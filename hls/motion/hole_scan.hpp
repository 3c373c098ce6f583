// SPDX-License-Identifier: Apache-2.0
// Where holes are filled, scan-out shows the holes alone: what else the pass has drawn is in the frame already. In any
// other pass scan goes by.
//
// A stamp without a hole is dropped, but for the last of the frame. Marks are cleared as they are read.
//
// Interval: a stamp a cycle.
#ifndef HALFSPACE_HLS_MOTION_HOLE_SCAN_HPP_
#define HALFSPACE_HLS_MOTION_HOLE_SCAN_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// A stamp; `fills`: of a pass that fills holes.
template <class F>
bool hole_scan(bool fills, Stream<Scan<F>>& scan, HoleMarks<F>& marks, Stream<Scan<F>>& masked) {
  Scan<F> out = scan.read();
  bool any = !fills || is_set(out.last);
  if (fills) {
    const int address = stamp_address<F>(out.x, out.y);
    Bit none[F::kLanes];
  Lanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      const bool hole = is_set(Bit(marks.hole[address][l]));
      any |= hole;
      out.index[l] = select(hole, out.index[l], from_raw<typename F::Index>(0));
      none[l] = from_raw<Bit>(0);
    }
    store_lanes(marks.hole, address, none);
  }
  if (any) masked.write(out);
  return is_set(out.last);
}

// All stamps.
template <class F>
void hole_scan_frame(bool fills, Stream<Scan<F>>& scan, HoleMarks<F>& marks, Stream<Scan<F>>& masked) {
  bool done = false;
Stamps:
  while (!done) {
    HS_PIPELINE(1)
    done = hole_scan(fills, scan, marks, masked);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_HOLE_SCAN_HPP_
