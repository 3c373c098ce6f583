// SPDX-License-Identifier: Apache-2.0
// The records of room shade: colours, normals and their planes, lights, and the stamps of scan-out.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_SHADE_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_SHADE_HPP_

#include "hls/formats/records/frame.hpp"

namespace halfspace {

// shade_setup → TdbS, the triangle database for shading: the entry of triangle `index`.
template <class F>
struct Planes {
  typename F::Bit last;
  typename F::Bit empty;  // nothing to store
  typename F::Index index;
  typename F::ColourPlane r;  // at the centre of pixel (0, 0) of the frame, ½ included; flat: the colour
  typename F::ColourGradient r_dx, r_dy;
  typename F::ColourPlane g;
  typename F::ColourGradient g_dx, g_dy;
  typename F::ColourPlane b;
  typename F::ColourGradient b_dx, b_dy;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index);
    v("r", r);
    if (F::kGouraud) v("r_dx", r_dx), v("r_dy", r_dy);
    v("g", g);
    if (F::kGouraud) v("g_dx", g_dx), v("g_dy", g_dy);
    v("b", b);
    if (F::kGouraud) v("b_dx", b_dx), v("b_dy", b_dy);
  }
};

// phong_setup → TdbS, with F::kPhong: the entry of triangle `index`. A component is 2^p units more than it is, so that
// it has no sign.
template <class F>
struct NormalPlanes {
  typename F::Bit last;
  typename F::Bit empty;  // nothing to store
  typename F::Index index;
  typename F::MaterialNumber material;
  typename F::NormalPlane start[3];  // x, y, z at the centre of pixel (0, 0) of the frame, ½ included
  typename F::NormalGradient dx[3], dy[3];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index), v("material", material);
    v("x", start[0]), v("x_dx", dx[0]), v("x_dy", dy[0]);
    v("y", start[1]), v("y_dx", dx[1]), v("y_dy", dy[1]);
    v("z", start[2]), v("z_dx", dx[2]), v("z_dy", dy[2]);
  }
};

// A light of the frame: unit vectors to it and, for highlights, half-way between it and the viewer.
template <class F>
struct Light {
  typename F::LightNumber light;
  typename F::Direction to_light[3], half[3];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("light", light);
    v("x", to_light[0]), v("y", to_light[1]), v("z", to_light[2]);
    if (F::kHasGloss) v("half_x", half[0]), v("half_y", half[1]), v("half_z", half[2]);
  }
};

// What a material makes of a light, in LSB of the colour. The bases of a material's lights add up to what it has
// without any.
template <class F>
struct Material {
  typename F::MaterialNumber material;
  typename F::LightNumber light;
  typename F::Gloss gloss;  // k: the exponent is 2^k; the same for all lights
  typename F::Coefficient base[3], diffuse[3], specular[3];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("material", material), v("light", light);
    if (F::kHasGloss) v("gloss", gloss);
    v("base_r", base[0]), v("base_g", base[1]), v("base_b", base[2]);
    v("diffuse_r", diffuse[0]), v("diffuse_g", diffuse[1]), v("diffuse_b", diffuse[2]);
    if (F::kHasGloss) v("specular_r", specular[0]), v("specular_g", specular[1]), v("specular_b", specular[2]);
  }
};

// geometry → light_vertex, or phong_setup, in answer to a Visible that says so: the normals of the triangle's vertices
// in the order given, of any length; one of length 0 shows the base alone. `last` and `index` are those of the Visible.
template <class F>
struct Normals {
  typename F::Bit last;
  typename F::Index index;
  typename F::MaterialNumber material;
  typename F::Normal x[3], y[3], z[3];  // flat: one, at [0]

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("index", index), v("material", material);
    v("x0", x[0]), v("y0", y[0]), v("z0", z[0]);
    if (F::kShadesPlanes) v("x1", x[1]), v("y1", y[1]), v("z1", z[1]), v("x2", x[2]), v("y2", y[2]), v("z2", z[2]);
  }
};

// light_vertex → shade_setup: the colours of a triangle.
template <class F>
struct Colours {
  typename F::Bit last;
  typename F::Index index;
  typename F::Colour r[3], g[3], b[3];  // flat: at [0]

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("index", index);
    visit_colours<F>(v, r, g, b);
  }
};

// scan_index → shade_gouraud, or shade_phong: a stamp of the finished I-buffer, rows downward, stamps to the right.
template <class F>
struct Scan {
  typename F::Index index[F::kLanes];  // lanes outside the frame: 0
  typename F::Bit last;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y);
    v.lanes("index", index);
  }
};

// The shader → frame, in the order of scan.
template <class F>
struct Pixel {
  typename F::Colour r[F::kLanes], g[F::kLanes], b[F::kLanes];
  typename F::Bit last;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y);
    v.lanes("r", r), v.lanes("g", g), v.lanes("b", b);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_SHADE_HPP_
