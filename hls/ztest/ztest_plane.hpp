// SPDX-License-Identifier: Apache-2.0
// The Z-test without a Z-buffer (index rendering, type γ): the stored index of a pixel fetches the depth plane of its
// triangle from TdbV, the triangle database for visibility, and the stored depth is computed again. A triangle of which
// no fragment passed is reported invisible and leaves nothing in TdbV.
//
// A fragment passes when its depth is less than the stored one; the first drawn wins a tie. A pixel of index 0 counts
// as farthest, 2^b − 1.
//
// The depth computed again has the bits of the depth that a Z-buffer would hold, so type γ draws the I-buffer of type
// δ, in every pixel. The rasterizer begins with P at pixel (x0, y0), adds and subtracts A = dx and B = dy, each b + g
// bits wide, modulo 2^b, and keeps every bit: at pixel (x, y) it has P + A·(x − x0) + B·(y − y0) mod 2^b, whatever its
// way there. TdbV holds C = P − A·x0 − B·y0 mod 2^b, A and B, so C + A·x + B·y mod 2^b is the same number, of which
// both take the upper b bits. This takes all b + g bits of A, B and C: with coefficients cut to fewer, as the 20, 28
// and 30 bits of the paper on index rendering, the depth computed again is off by up to (x + y)·2^−(g'+1) and more LSB,
// g' the fraction bits that are left; an order of two triangles nearer than that can turn round, and differs from type
// δ's.
//
// Interval: a cycle for each different triangle stored in the covered lanes of a stamp, one if there is none, and one a
// triangle for C.
#ifndef HALFSPACE_HLS_ZTEST_ZTEST_PLANE_HPP_
#define HALFSPACE_HLS_ZTEST_ZTEST_PLANE_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// C, A and B of a triangle.
template <class F>
DepthEntry<F> depth_entry(const TriangleDepth<F>& in) {
  using Plane = typename F::DepthPlane;
  const Plane along_x = in.depth_dx * shift_left(in.x, F::kLog2LanesX);
  const Plane along_y = in.depth_dy * shift_left(in.y, F::kLog2LanesY);
  const Plane origin_x = in.depth - along_x;
  DepthEntry<F> entry;
  entry.origin = origin_x - along_y;
  entry.dx = in.depth_dx;
  entry.dy = in.depth_dy;
  return entry;
}

// The depths stored of a stamp. Returns what they cost: the triangles that they are of.
template <class F>
int stored_depths(const Stamp<F>& in, const typename F::Index (&index)[F::kLanes],
                  const VisibilityDatabase<F>& database, typename F::Depth (&depth)[F::kLanes]) {
  const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
  Bit waits[F::kLanes], group[F::kLanes];
Background:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    depth[l] = farthest_depth<F>();
    waits[l] = from_raw<Bit>(is_set(in.mask[l]) && !is_zero(index[l]));
  }
  int groups = 0;
Triangles:
  for (; groups < F::kLanes; ++groups) {
    HS_PIPELINE(1)
    const int triangle = next_group<F>(index, waits, group);
    if (triangle == 0) break;
    const DepthEntry<F> plane = database.entry[triangle - 1];
    plane_lanes<F>(plane.origin, plane.dx, plane.dy, x, y, group, depth);
  }
  return groups;
}

// `tests` hears what the stamps of a triangle cost.
template <Until kUntil, class F>
bool ztest_plane_stamps(Stream<Stamp<F>>& stamp, Stream<TriangleDepth<F>>& depth_plane, IndexBuffer<F>& index_buffer,
                        VisibilityDatabase<F>& database, Probe<Update<F>>& update, Stream<Visible<F>>& visible,
                        Probe<PlaneTests>& tests) {
  using Index = typename F::Index;
  DepthEntry<F> entry{};
  PlaneTests cost{};
  bool is_first = true, any_of_triangle = false, last = false;
Stamps:
  for (;;) {
    if (is_first) {
      entry = depth_entry(depth_plane.read());
      cost = {1, 0};
      any_of_triangle = false;
    }
    const Stamp<F> in = stamp.read();
    const int address = stamp_address<F>(in.x, in.y);
    Index index[F::kLanes];
    typename F::Depth depth[F::kLanes];
  Indices:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      index[l] = trimmed(index_buffer.index[address][l]);
    }
    const int groups = stored_depths(in, index, database, depth);
    cost.cycles += groups == 0 ? 1 : groups;
    cost.entries += groups;

    Update<F> out{};
    out.index = in.index;
    out.x = in.x;
    out.y = in.y;
    unsigned any = 0;
  Lanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      const unsigned pass = unsigned(is_set(in.mask[l])) & unsigned(in.depth[l] < depth[l]);
      any |= pass;
      out.mask[l] = from_raw<Bit>(pass);
      index[l] = select(pass != 0, in.index, index[l]);
    }
    store_lanes(index_buffer.index, address, index);
    if (any) update.write(out);
    if (any && !any_of_triangle) database.entry[int(raw(in.index)) - 1] = entry;
    any_of_triangle = any_of_triangle || any;
    is_first = is_set(in.triangle_last);
    if (is_first) {
      Visible<F> result;
      result.last = in.last;
      result.visible = from_raw<Bit>(any_of_triangle);
      result.index = in.index;
      visible.write(result);
      tests.write(cost);
      last = is_set(in.last);
      if (kUntil == Until::kTriangleEnds || last) break;
    }
  }
  return last;
}

template <class F>
bool ztest_plane(Stream<Stamp<F>>& stamp, Stream<TriangleDepth<F>>& depth_plane, IndexBuffer<F>& index_buffer,
                 VisibilityDatabase<F>& database, Probe<Update<F>>& update, Stream<Visible<F>>& visible,
                 Probe<PlaneTests>& tests) {
  return ztest_plane_stamps<Until::kTriangleEnds>(stamp, depth_plane, index_buffer, database, update, visible, tests);
}
template <class F>
void ztest_plane_frame(Stream<Stamp<F>>& stamp, Stream<TriangleDepth<F>>& depth_plane, IndexBuffer<F>& index_buffer,
                       VisibilityDatabase<F>& database, Probe<Update<F>>& update, Stream<Visible<F>>& visible,
                       Probe<PlaneTests>& tests) {
  ztest_plane_stamps<Until::kFrameEnds>(stamp, depth_plane, index_buffer, database, update, visible, tests);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_ZTEST_ZTEST_PLANE_HPP_
