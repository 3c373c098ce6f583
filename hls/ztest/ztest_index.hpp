// SPDX-License-Identifier: Apache-2.0
// The Z-test with an index buffer (index rendering, type δ): the Z-buffer and the I-buffer are tested and updated
// together, and a triangle of which no fragment passed is reported invisible.
//
// A fragment passes when its depth is less than the stored one; the first drawn wins a tie. A pixel of index 0 has
// nothing stored and counts as farthest, 2^b − 1, whatever its depth word holds: clearing the I-buffer clears both.
// Without depth all lie equally far, so a fragment passes where the index is 0.
//
// Interval: a stamp a cycle.
#ifndef HALFSPACE_HLS_ZTEST_ZTEST_INDEX_HPP_
#define HALFSPACE_HLS_ZTEST_ZTEST_INDEX_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// What is stored of the pixels of a stamp.
template <class F>
struct StoredStamp {
  typename F::Index index[F::kLanes];
  typename F::Depth depth[F::kLanes];  // with F::kHasDepth
};

template <class F>
HS_INLINE inline StoredStamp<F> read_stamp(const IndexBuffer<F>& index_buffer, const DepthBuffer<F>& depth_buffer,
                                           int address) {
  StoredStamp<F> stored;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    stored.index[l] = trimmed(index_buffer.index[address][l]);
    stored.depth[l] = trimmed(depth_buffer.depth[F::kHasDepth ? address : 0][l]);
  }
  return stored;
}

template <class F>
HS_INLINE inline void write_stamp(const StoredStamp<F>& stored, int address, IndexBuffer<F>& index_buffer,
                                  DepthBuffer<F>& depth_buffer) {
  store_lanes(index_buffer.index, address, stored.index);
  if (F::kHasDepth) store_lanes(depth_buffer.depth, address, stored.depth);
}

// Puts the fragments that pass in the place of what is stored. Returns whether there are any.
template <class F>
HS_INLINE inline bool test_stamp(const Stamp<F>& in, StoredStamp<F>& stored, Update<F>& update) {
  const typename F::Depth farthest = farthest_depth<F>();
  update.index = in.index;
  update.x = in.x;
  update.y = in.y;
  unsigned any = 0;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const bool first = is_zero(stored.index[l]);
    bool nearer = first;
    if (F::kHasDepth) nearer = in.depth[l] < select(first, farthest, stored.depth[l]);
    const unsigned pass = unsigned(is_set(in.mask[l])) & unsigned(nearer);
    any |= pass;
    update.mask[l] = from_raw<Bit>(pass);
    update.depth[l] = in.depth[l];
    stored.index[l] = select(pass != 0, in.index, stored.index[l]);
    if (F::kHasDepth) stored.depth[l] = select(pass != 0, in.depth[l], stored.depth[l]);
  }
  return any != 0;
}

// A stamp that has been tested and is not written yet.
template <class F>
struct LateStamp {
  int address;
  StoredStamp<F> stored;
};

// The stamps of a triangle are different ones, and each is written when it has been tested. Those of a frame are
// written two stamps later, and until then forwarded to the tests of the same stamp: so a pipeline that reads a stamp
// while the two before it are tested has an iteration a cycle, with one read and one write in each. What is late at
// first is the first stamp of the buffers, as it is.
template <Until kUntil, class F>
bool ztest_index_stamps(Stream<Stamp<F>>& stamp, IndexBuffer<F>& index_buffer, DepthBuffer<F>& depth_buffer,
                        Probe<Update<F>>& update, Stream<Visible<F>>& visible) {
  constexpr bool kLate = kUntil == Until::kFrameEnds;
  LateStamp<F> near{}, far{};  // the stamp before, and the one before that
  if (kLate) near.stored = far.stored = read_stamp(index_buffer, depth_buffer, 0);
  bool any_of_triangle = false, last = false;
Stamps:
  for (;;) {
    HS_PIPELINE(1)
    const Stamp<F> in = stamp.read();
    const int address = stamp_address<F>(in.x, in.y);
    StoredStamp<F> stored = read_stamp(index_buffer, depth_buffer, address);
    if (kLate) {
      write_stamp(far.stored, far.address, index_buffer, depth_buffer);
      if (far.address == address) stored = far.stored;
      if (near.address == address) stored = near.stored;
      far = near;
    }
    Update<F> out;
    const bool any = test_stamp(in, stored, out);
    if (kLate) {
      near.address = address;
      near.stored = stored;
    } else {
      write_stamp(stored, address, index_buffer, depth_buffer);
    }
    if (any) update.write(out);
    any_of_triangle = any_of_triangle || any;
    if (is_set(in.triangle_last)) {
      Visible<F> result;
      result.last = in.last;
      result.visible = from_raw<Bit>(any_of_triangle);
      result.index = in.index;
      visible.write(result);
      any_of_triangle = false;
      last = is_set(in.last);
      if (kUntil == Until::kTriangleEnds || last) break;
    }
  }
  if (kLate) {
    // A tool with a port for each may do both at once, so there is one if they go to one place.
    if (far.address != near.address) write_stamp(far.stored, far.address, index_buffer, depth_buffer);
    write_stamp(near.stored, near.address, index_buffer, depth_buffer);
  }
  return last;
}

template <class F>
bool ztest_index(Stream<Stamp<F>>& stamp, IndexBuffer<F>& index_buffer, DepthBuffer<F>& depth_buffer,
                 Probe<Update<F>>& update, Stream<Visible<F>>& visible) {
  return ztest_index_stamps<Until::kTriangleEnds>(stamp, index_buffer, depth_buffer, update, visible);
}
template <class F>
void ztest_index_frame(Stream<Stamp<F>>& stamp, IndexBuffer<F>& index_buffer, DepthBuffer<F>& depth_buffer,
                       Probe<Update<F>>& update, Stream<Visible<F>>& visible) {
  ztest_index_stamps<Until::kFrameEnds>(stamp, index_buffer, depth_buffer, update, visible);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_ZTEST_ZTEST_INDEX_HPP_
