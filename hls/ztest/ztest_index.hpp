// SPDX-License-Identifier: Apache-2.0
// The Z-test with an index buffer (index rendering, type δ): the Z-buffer and the I-buffer are tested and updated
// together, and a triangle of which no fragment passed is reported invisible.
//
// A fragment passes when its depth is less than the stored one; the first drawn wins a tie. A pixel of index 0 has
// nothing stored and counts as farthest, 2^b − 1, whatever its depth word holds: clearing the I-buffer clears both.
// Without depth all lie equally far, so a fragment passes where the index is 0.
// A stamp a cycle.
#ifndef HALFSPACE_HLS_ZTEST_ZTEST_INDEX_HPP_
#define HALFSPACE_HLS_ZTEST_ZTEST_INDEX_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

// The stamps of one triangle.
template <class F>
bool ztest_index(Stream<Stamp<F>>& stamp, IndexBuffer<F>& index_buffer, DepthBuffer<F>& depth_buffer,
                 Probe<Update<F>>& update, Stream<Visible<F>>& visible) {
  using Depth = typename F::Depth;
  const typename Depth::Carrier farthest = raw(farthest_depth<F>());
  bool any_of_triangle = false;
  bool done = false, last = false;
Stamps:
  for (int n = 0; n < F::kStamps && !done; ++n) {
    HS_PIPELINE(1)
    const Stamp<F> in = stamp.read();
    const int address = int(raw(in.y)) * F::kStampsX + int(raw(in.x));
    typename F::Index* const stored_index = index_buffer.index[address];
    Depth* const stored_depth = depth_buffer.depth[F::kHasDepth ? address : 0];

    Update<F> out;
    out.index = in.index;
    out.x = in.x;
    out.y = in.y;
    typename Bit::Carrier any = 0;
  Lanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      const auto index = raw(stored_index[l]);
      typename Bit::Carrier nearer = typename Bit::Carrier(index == 0);
      const auto depth = raw(in.depth[l]);
      if (F::kHasDepth) nearer = typename Bit::Carrier(depth < (index == 0 ? farthest : raw(stored_depth[l])));
      const typename Bit::Carrier pass = raw(in.mask[l]) & nearer;
      any |= pass;
      out.mask[l] = from_raw<Bit>(pass);
      out.depth[l] = from_raw<Depth>(depth);
      stored_index[l] = from_raw<typename F::Index>(pass ? raw(in.index) : index);
      if (F::kHasDepth) stored_depth[l] = from_raw<Depth>(pass ? depth : raw(stored_depth[l]));
    }
    if (any) update.write(out);
    any_of_triangle = any_of_triangle || any;
    done = is_set(in.triangle_last);
    if (done) {
      Visible<F> result;
      result.last = in.last;
      result.visible = from_raw<Bit>(any_of_triangle);
      result.index = in.index;
      visible.write(result);
      last = is_set(in.last);
    }
  }
  return last;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_ZTEST_ZTEST_INDEX_HPP_
