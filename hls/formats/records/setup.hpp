// SPDX-License-Identifier: Apache-2.0
// The records of room setup: a triangle as it comes, and what is made of it for the rasterizer and for planes.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_SETUP_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_SETUP_HPP_

#include "hls/formats/records/frame.hpp"

namespace halfspace {

// vertices → triangle_setup. Either winding. Index 0 with three equal vertices is no triangle at all: it carries
// `last` for a frame without triangles.
template <class F>
struct Triangle {
  typename F::Bit last;  // of the frame
  typename F::Index index;
  typename F::Object object;  // that the triangle is of; not 0
  typename F::Face face;      // F::kUpConverts: of the scene that the triangle is of, as its key pixels have it; not 0
  typename F::Coord x[3], y[3];
  typename F::Depth depth[3];
  typename F::Colour r[3], g[3], b[3];  // flat: at [0]

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("index", index);
    visit_vertices(v);
  }
  template <class V>
  HS_INLINE constexpr void visit_vertices(V&& v) {
    if (F::kHasObjects) v("object", object);
    if (F::kUpConverts) v("face", face);
    v("x0", x[0]), v("x1", x[1]), v("x2", x[2]);
    v("y0", y[0]), v("y1", y[1]), v("y2", y[2]);
    if (F::kHasDepth) v("depth0", depth[0]), v("depth1", depth[1]), v("depth2", depth[2]);
    if (F::kHasColours) visit_colours<F>(v, r, g, b);
  }
};

// The same without an index, with F::kGivesIndices: vertices → index_pool.
template <class F>
struct UnnumberedTriangle : Triangle<F> {
  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", this->last);
    this->visit_vertices(v);
  }
};

// triangle_setup → raster_pineda, one a triangle. Positions in stamps.
template <class F>
struct Setup {
  typename F::Bit last;
  typename F::Bit
      empty;  // no pixel centre of the frame lies in the bounding box, or the area is zero; the rest then means nothing
  typename F::Index index;
  typename F::X x_min, x_max, x_start;  // bounding box in the frame; where to look first in its top row
  typename F::Y y_min, y_max;
  // Edge functions at the centre of the first pixel of stamp (x_start, y_min): inside is >= 0 in all three.
  typename F::EdgeStep e[3];
  typename F::Delta e_dx[3], e_dy[3];  // steps of one pixel
  typename F::DepthPlane depth;        // at the same centre, ½ included
  typename F::DepthGradient depth_dx, depth_dy;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index);
    v("x_min", x_min), v("x_max", x_max), v("x_start", x_start);
    v("y_min", y_min), v("y_max", y_max);
    v("e0", e[0]), v("e1", e[1]), v("e2", e[2]);
    v("e0_dx", e_dx[0]), v("e1_dx", e_dx[1]), v("e2_dx", e_dx[2]);
    v("e0_dy", e_dy[0]), v("e1_dy", e_dy[1]), v("e2_dy", e_dy[2]);
    if (F::kHasDepth) v("depth", depth), v("depth_dx", depth_dx), v("depth_dy", depth_dy);
  }
};

// triangle_setup → shade_setup: what the planes need, of each triangle that is not empty and of the last. A flat
// triangle without texture needs its colour alone. With F::kDeferred of every triangle, to visible_select; and of the
// visible ones and the last, in which `empty` is that it is not visible, from there to shade_setup or phong_setup, and
// texture_setup.
template <class F>
struct Attributes {
  typename F::Bit last;
  typename F::Bit empty;
  typename F::Index index;
  typename F::Coord x, y;  // vertex 0
  typename F::Delta dx1, dy1, dx2, dy2;
  typename F::Shift shift;
  typename F::Reciprocal reciprocal;
  // Where values of the vertices come later: which vertex, as given, vertex 0 is; and whether the other two follow it
  // backwards.
  typename F::VertexNumber first;
  typename F::Bit turned;
  typename F::Colour r[3], g[3], b[3];  // flat: at [0]

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index);
    if (F::kSendsShape) {
      v("x", x), v("y", y);
      v("dx1", dx1), v("dy1", dy1), v("dx2", dx2), v("dy2", dy2);
      v("shift", shift), v("reciprocal", reciprocal);
    }
    if (F::kOrdersVertices) v("first", first), v("turned", turned);
    if (F::kHasColours) visit_colours<F>(v, r, g, b);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_SETUP_HPP_
