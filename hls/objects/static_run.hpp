// SPDX-License-Identifier: Apache-2.0
// The D-buffer and the S-buffers in memory, before ztest_merge and after it: reads the stamps that a run takes, and
// puts where they belong those that it sends.
//
//   stored   of each stamp of the box, row by row: what a buffer has there, or background
//   drawn    if it merges, the same of another buffer; or of a pass, the next frame of hs_pipeline, which sends its
//            stamps row by row too. Those outside the box are dropped
//   merged   into the frame, or into a buffer, which may be one of those that are read
//
// A run ends with its last stamp: what the next one reads is there.
//
// Interval: a stamp a cycle, of a pass each of its frame; of the RTL 4 more a run, and 2 without `sends`, where a place
// is answered in the next cycle.
#ifndef HALFSPACE_HLS_OBJECTS_STATIC_RUN_HPP_
#define HALFSPACE_HLS_OBJECTS_STATIC_RUN_HPP_

#include "hls/formats/static_records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// A stamp of a box.
template <class F>
struct BoxPlace {
  typename F::X x;
  typename F::Y y;

  bool ends(const StaticCommand<F>& run) const { return x == run.x_last && y == run.y_last; }
  void advance(const StaticCommand<F>& run) {
    const typename F::X next_x = x + from_raw<typename F::X>(1);
    const typename F::Y next_y = y + from_raw<typename F::Y>(1);
    const bool row_ends = x == run.x_last;
    y = select(row_ends, next_y, y);
    x = select(row_ends, run.x_first, next_x);
  }
};

template <class F>
StampPixels<F> background_pixels(const Merge<F>& run) {
  StampPixels<F> out;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    out.depth[l] = farthest_depth<F>();
    out.object[l] = from_raw<typename F::Object>(0);
    out.r[l] = run.r;
    out.g[l] = run.g;
    out.b[l] = run.b;
  }
  return out;
}

template <class F>
StampPixels<F> pixels_of(const Entry<F>& in) {
  StampPixels<F> out;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    out.depth[l] = in.depth[l];
    out.object[l] = in.object[l];
    out.r[l] = in.r[l];
    out.g[l] = in.g[l];
    out.b[l] = in.b[l];
  }
  return out;
}

template <class F>
Entry<F> entry_of(const StampPixels<F>& in, const BoxPlace<F>& at, bool last) {
  Entry<F> out;
  out.last = from_raw<typename F::Bit>(int(last));
  out.x = at.x;
  out.y = at.y;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    out.depth[l] = in.depth[l];
    out.object[l] = in.object[l];
    out.r[l] = in.r[l];
    out.g[l] = in.g[l];
    out.b[l] = in.b[l];
  }
  return out;
}

template <class F>
BufferPlace<F> place_of(const BufferNumber<F>& buffer, const BoxPlace<F>& at) {
  BufferPlace<F> out;
  out.buffer = buffer;
  out.x = at.x;
  out.y = at.y;
  return out;
}

// Before ztest_merge. memory.read_stored(place) and memory.read_drawn(place) are the pixels there.
template <class F, class Memory>
void static_fetch(const StaticCommand<F>& run, Memory& memory, Stream<Entry<F>>& entry, Stream<Merge<F>>& merge,
                  Stream<Entry<F>>& stored, Stream<Entry<F>>& drawn) {
  merge.write(run);
  const bool passes = is_set(run.passes), merges = is_set(run.merges);
  BoxPlace<F> at;
  at.x = run.x_first;
  at.y = run.y_first;
  bool box_done = false, pass_done = !passes;
Stamps:
  for (int n = 0; n < F::kStamps && !(box_done && pass_done); ++n) {
    HS_PIPELINE(1)
    bool inside = !box_done;
    StampPixels<F> other = background_pixels<F>(run);
    if (passes) {
      const Entry<F> in = entry.read();
      inside = inside && in.x == at.x && in.y == at.y;
      pass_done = is_set(in.last);
      other = pixels_of(in);
    }
    if (inside) {
      const bool last = at.ends(run);
      StampPixels<F> pixels = background_pixels<F>(run);
      if (!is_set(run.anew)) pixels = memory.read_stored(place_of<F>(run.stored, at));
      if (merges && !passes) other = memory.read_drawn(place_of<F>(run.drawn, at));
      stored.write(entry_of(pixels, at, last));
      if (merges) drawn.write(entry_of(other, at, last));
      at.advance(run);
      box_done = last;
    }
  }
}

// After it. memory.keep(stamp) writes one.
template <class F, class Memory>
void static_store(const StaticCommand<F>& run, Memory& memory, Stream<Entry<F>>& merged, Stream<Entry<F>>& shown) {
  bool done = !is_set(run.sends);
Stamps:
  for (int n = 0; n < F::kStamps && !done; ++n) {
    HS_PIPELINE(1)
    const Entry<F> in = merged.read();
    if (is_set(run.shows)) {
      shown.write(in);
    } else {
      KeptStamp<F> kept;
      kept.place.buffer = run.kept;
      kept.place.x = in.x;
      kept.place.y = in.y;
      kept.pixels = pixels_of(in);
      memory.keep(kept);
    }
    done = is_set(in.last);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_OBJECTS_STATIC_RUN_HPP_
