// SPDX-License-Identifier: Apache-2.0
// The records of rooms raster and ztest: stamps, what becomes of them, and whether their triangle is visible.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_RASTER_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_RASTER_HPP_

#include "hls/formats/records/frame.hpp"

namespace halfspace {

// raster_pineda → ztest_plane, with F::kTestsPlanes alone: the depth plane of each triangle, as in its Setup, before
// its first stamp. Of an empty triangle it means nothing.
template <class F>
struct TriangleDepth {
  typename F::Index index;
  typename F::X x;  // the stamp whose first pixel the plane starts at
  typename F::Y y;
  typename F::DepthPlane depth;
  typename F::DepthGradient depth_dx, depth_dy;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("index", index), v("x", x), v("y", y);
    v("depth", depth), v("depth_dx", depth_dx), v("depth_dy", depth_dy);
  }
};

// raster_pineda → the Z-test, ztest_index or ztest_plane: a stamp with a covered pixel. A triangle that covers none
// sends one with an empty mask, for the end of the triangle.
template <class F>
struct Stamp {
  typename F::Bit mask[F::kLanes];
  typename F::Depth depth[F::kLanes];  // of the plane, also where the mask is 0 and it means nothing
  typename F::Bit last;                // of the frame
  typename F::Bit triangle_last;       // of the triangle
  typename F::Index index;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("triangle_last", triangle_last), v("index", index), v("x", x), v("y", y);
    v.lanes("mask", mask);
    if (F::kHasDepth) v.lanes("depth", depth);
  }
};

// Where the stamps end that a call of a kernel takes.
enum class Until { kStampEnds, kTriangleEnds, kFrameEnds };

// What the stamps of a triangle cost ztest_plane: cycles, and entries of TdbV that it reads.
struct PlaneTests {
  int cycles, entries;
};

// The Z-test → I-buffer and Z-buffer, if there is one: a write, of a stamp of which a fragment passed.
template <class F>
struct Update {
  typename F::Bit mask[F::kLanes];  // lanes that passed
  typename F::Depth depth[F::kLanes];
  typename F::Index index;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("index", index), v("x", x), v("y", y);
    v.lanes("mask", mask);
    if (F::kStoresDepth) v.lanes("depth", depth);
  }
};

// The Z-test → geometry: a triangle is done, and a fragment of it passed or none did.
template <class F>
struct Visible {
  typename F::Bit last;
  typename F::Bit visible;
  typename F::Index index;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("visible", visible), v("index", index);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_RASTER_HPP_
