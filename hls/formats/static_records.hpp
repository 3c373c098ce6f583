// SPDX-License-Identifier: Apache-2.0
// The records of static_run, with F::kHasObjects: what hs_static_frames is told, and the stamps of the D-buffer and of
// the S-buffers in the memory outside. All places are in stamps.
#ifndef HALFSPACE_HLS_FORMATS_STATIC_RECORDS_HPP_
#define HALFSPACE_HLS_FORMATS_STATIC_RECORDS_HPP_

#include "hls/formats/object_records.hpp"

namespace halfspace {

// Of a buffer in memory: the driver gives the numbers, as the D-buffer 0, S-buffers 1, 2, …, and one for their merge.
template <class F>
using BufferNumber = typename F::Bit::template Other<4, 4, false>;

// A run of ztest_merge, and where its stamps come from and go to.
template <class F>
struct StaticCommand : Merge<F> {
  typename F::Bit passes;               // what is drawn is the next frame of hs_pipeline, else a buffer
  typename F::Bit anew;                 // what is stored is background, else a buffer
  typename F::Bit shows;                // what is sent goes to the frame, else into a buffer
  BufferNumber<F> stored, drawn, kept;  // these buffers
  typename F::X x_first, x_last;        // the box, inside the frame
  typename F::Y y_first, y_last;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("passes", passes), v("anew", anew), v("shows", shows);
    v("stored", stored), v("drawn", drawn), v("kept", kept);
    v("x_first", x_first), v("x_last", x_last);
    v("y_first", y_first), v("y_last", y_last);
    Merge<F>::visit(v);
  }
};

// A stamp that is read.
template <class F>
struct BufferPlace {
  BufferNumber<F> buffer;
  typename F::X x;
  typename F::Y y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("buffer", buffer), v("x", x), v("y", y);
  }
};

// What it is, as memory has it.
template <class F>
struct StampPixels {
  typename F::Depth depth[F::kLanes];
  typename F::Object object[F::kLanes];
  typename F::Colour r[F::kLanes], g[F::kLanes], b[F::kLanes];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v.lanes("depth", depth), v.lanes("object", object);
    v.lanes("r", r), v.lanes("g", g), v.lanes("b", b);
  }
};

// A stamp that is written.
template <class F>
struct KeptStamp {
  BufferPlace<F> place;
  StampPixels<F> pixels;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    place.visit(v);
    pixels.visit(v);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_STATIC_RECORDS_HPP_
