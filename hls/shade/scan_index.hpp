// SPDX-License-Identifier: Apache-2.0
// Scan-out of the I-buffer, and its clearing for the next frame in the same pass.
//
// Interval: a stamp a cycle.
#ifndef HALFSPACE_HLS_SHADE_SCAN_INDEX_HPP_
#define HALFSPACE_HLS_SHADE_SCAN_INDEX_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

template <class F>
struct StampPlace {
  typename F::X x;
  typename F::Y y;
};
// Of the frame's last pixel.
template <class F>
StampPlace<F> last_stamp(const Frame<F>& frame) {
  using X = typename F::X;
  using Y = typename F::Y;
  StampPlace<F> place;
  place.x = shift_right(X(frame.width - from_raw<X>(1)), F::kLog2LanesX);
  place.y = shift_right(Y(frame.height - from_raw<Y>(1)), F::kLog2LanesY);
  return place;
}

// What is stored of a stamp; nothing is afterwards.
template <class F>
HS_INLINE inline Scan<F> take_stamp(const StampPlace<F>& at, bool is_last, IndexBuffer<F>& index_buffer) {
  const int address = stamp_address<F>(at.x, at.y);
  Scan<F> out;
  out.last = from_raw<Bit>(is_last);
  out.x = at.x;
  out.y = at.y;
  typename F::Index none[F::kLanes];
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    out.index[l] = trimmed(index_buffer.index[address][l]);
    none[l] = from_raw<typename F::Index>(0);
  }
  store_lanes(index_buffer.index, address, none);
  return out;
}

// A row of stamps.
template <class F>
void scan_index(const Frame<F>& frame, int y, IndexBuffer<F>& index_buffer, Stream<Scan<F>>& scan) {
  const StampPlace<F> end = last_stamp(frame);
  StampPlace<F> at;
  at.x = from_raw<typename F::X>(0);
  at.y = from_raw<typename F::Y>(y);
  const bool is_last_row = at.y == end.y;
  bool done = false;
Stamps:
  for (int n = 0; n < F::kStampsX && !done; ++n) {
    HS_PIPELINE(1)
    done = at.x == end.x;
    scan.write(take_stamp(at, done && is_last_row, index_buffer));
    at.x = at.x + from_raw<typename F::X>(1);
  }
}

// All rows.
template <class F>
void scan_index_frame(const Frame<F>& frame, IndexBuffer<F>& index_buffer, Stream<Scan<F>>& scan) {
  using X = typename F::X;
  using Y = typename F::Y;
  const StampPlace<F> end = last_stamp(frame);
  StampPlace<F> at;
  at.x = from_raw<X>(0);
  at.y = from_raw<Y>(0);
  bool done = false;
Stamps:
  for (int n = 0; n < F::kStamps && !done; ++n) {
    HS_PIPELINE(1)
    const bool row_ends = at.x == end.x;
    done = row_ends && at.y == end.y;
    const Scan<F> word = take_stamp(at, done, index_buffer);
    // Before the word goes: Bambu has a narrow comparison where its last user stands, and a write does not wait for it.
    at.x = select(row_ends, from_raw<X>(0), X(at.x + from_raw<X>(1)));
    at.y = select(row_ends, Y(at.y + from_raw<Y>(1)), at.y);
    scan.write(word);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SCAN_INDEX_HPP_
