// SPDX-License-Identifier: Apache-2.0
// The records of static objects buffers, with F::kHasObjects: pixels that know their object, and what ztest_merge is
// told and tells. The background is {depth 2^b − 1, object 0}. All places are in stamps.
#ifndef HALFSPACE_HLS_FORMATS_OBJECT_RECORDS_HPP_
#define HALFSPACE_HLS_FORMATS_OBJECT_RECORDS_HPP_

#include "hls/formats/records.hpp"

namespace halfspace {

// scan_object → join_entry: what a stamp shows, but for its colours.
template <class F>
struct ObjectPixel {
  typename F::Depth depth[F::kLanes];
  typename F::Object object[F::kLanes];
  typename F::Bit last;
  typename F::X x;
  typename F::Y y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y);
    v.lanes("depth", depth), v.lanes("object", object);
  }
};

// A stamp of the D-buffer, as join_entry sends it in the place of Pixel, of an S-buffer, or of what they are merged
// into.
template <class F>
struct Entry : Pixel<F> {
  typename F::Depth depth[F::kLanes];
  typename F::Object object[F::kLanes];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", this->last), v("x", this->x), v("y", this->y);
    v.lanes("depth", depth), v.lanes("object", object);
    v.lanes("r", this->r), v.lanes("g", this->g), v.lanes("b", this->b);
  }
};

// What a run of ztest_merge is to do.
template <class F>
struct Merge {
  typename F::Bit merges;          // a word of `entry` comes with each of `stored`
  typename F::Bit sends;           // a word of `merged` goes for each of these
  typename F::Object first, last;  // objects that are looked for and erased; none if first > last
  typename F::Colour r, g, b;      // of the background, which erased pixels become

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("merges", merges), v("sends", sends), v("first", first), v("last", last);
    v("r", r), v("g", g), v("b", b);
  }
};

// ztest_merge → the driver, at the end of a run: the pixels of `stored` that show an object of the range, and the box
// of their stamps. All 0 where there is none.
template <class F>
struct Found {
  typename F::ObjectCount count;
  typename F::X x_first, x_last;
  typename F::Y y_first, y_last;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("count", count);
    v("x_first", x_first), v("x_last", x_last);
    v("y_first", y_first), v("y_last", y_last);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_OBJECT_RECORDS_HPP_
