// SPDX-License-Identifier: Apache-2.0
// Scan-out of the I-buffer, and its clearing for the next frame in the same pass. A stamp a cycle; a call does one row
// of stamps.
#ifndef HALFSPACE_HLS_SHADE_SCAN_INDEX_HPP_
#define HALFSPACE_HLS_SHADE_SCAN_INDEX_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

template <class F>
void scan_index(const Frame<F>& frame, int y, IndexBuffer<F>& index_buffer, Stream<Scan<F>>& scan) {
  const int x_last = (int(raw(frame.width)) - 1) >> F::kLog2LanesX;
  const int y_last = (int(raw(frame.height)) - 1) >> F::kLog2LanesY;
Stamps:
  for (int x = 0; x < F::kStampsX && x <= x_last; ++x) {
    HS_PIPELINE(1)
    Scan<F> out;
    out.last = from_raw<Bit>(x == x_last && y == y_last);
    out.x = from_raw<typename F::X>(x);
    out.y = from_raw<typename F::Y>(y);
    typename F::Index* const stored = index_buffer.index[y * F::kStampsX + x];
  Lanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      out.index[l] = from_raw<typename F::Index>(raw(stored[l]));
      stored[l] = from_raw<typename F::Index>(0);
    }
    scan.write(out);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SCAN_INDEX_HPP_
