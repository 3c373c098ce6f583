// SPDX-License-Identifier: Apache-2.0
// Scan-out of the I-buffer, and its clearing for the next frame in the same pass. A stamp a cycle.
#ifndef HALFSPACE_HLS_SCAN_INDEX_HPP_
#define HALFSPACE_HLS_SCAN_INDEX_HPP_

#include "buffers.hpp"
#include "stream.hpp"

namespace halfspace {

template <class F>
void scan_index(const Frame<F>& frame, IndexBuffer<F>& index_buffer, Stream<Scan<F>>& scan) {
  const int x_last = (int(raw(frame.width)) - 1) >> F::kLog2LanesX;
  const int y_last = (int(raw(frame.height)) - 1) >> F::kLog2LanesY;
  int x = 0, y = 0;
  bool done = false;
Stamps:
  for (int n = 0; n < F::kStamps && !done; ++n) {
    HS_PIPELINE(1)
    Scan<F> out;
    done = x == x_last && y == y_last;
    out.last = from_raw<Bit>(done);
    out.x = from_raw<typename F::X>(x);
    out.y = from_raw<typename F::Y>(y);
    typename F::Index* const stored = index_buffer.index[y * F::kStampsX + x];
  Lanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      out.index[l] = stored[l];
      stored[l] = from_raw<typename F::Index>(0);
    }
    scan.write(out);
    y = x == x_last ? y + 1 : y;
    x = x == x_last ? 0 : x + 1;
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SCAN_INDEX_HPP_
