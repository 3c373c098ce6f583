// SPDX-License-Identifier: Apache-2.0
// The records that travel between the units, one struct a stream.
//
// visit() names the fields once, in the order of a SystemVerilog packed struct: the first is the most significant.
// Packing, manifests, the RTL package and the reports of mismatches all read the layout from there. Fields that
// come once a lane stand last in the word, lane 0 in the least significant place, and first in memory, where a
// processor's vectors find them aligned. A field that a configuration has no use for is not visited, so that no word
// has it: depths without F::kHasDepth, depths of the Z-buffer without F::kStoresDepth, colours of the other vertices
// and colour planes without F::kGouraud. With F::kHasLighting a triangle comes without colours, and its normals once it
// is visible; with F::kPhong its planes are of normals. With F::kHasTexture it has planes of texture coordinates
// besides. With F::kHasObjects it knows its object.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_HPP_

#include "hls/formats/formats.hpp"

namespace halfspace {

using Bit = ufix<1, 1>;
using VertexNumber = ufix<2, 2>;  // 0 … 2

// Of a pixel that shows the background: 2^b − 1.
template <class F>
typename F::Depth farthest_depth() {
  return from_raw<typename F::Depth>((std::int64_t(1) << F::kDepthBits) - 1);
}

// A frame's registers: stable from its first triangle to its last pixel.
template <class F>
struct Frame {
  typename F::X width;         // 1 … F::kWidth pixels
  typename F::Y height;        // 1 … F::kHeight pixels
  typename F::Colour r, g, b;  // background
};

// The colours of a triangle: of its vertices, or one.
template <class F, class V>
void visit_colours(V&& v, typename F::Colour (&r)[3], typename F::Colour (&g)[3], typename F::Colour (&b)[3]) {
  if (F::kGouraud) {
    v("r0", r[0]), v("r1", r[1]), v("r2", r[2]);
    v("g0", g[0]), v("g1", g[1]), v("g2", g[2]);
    v("b0", b[0]), v("b1", b[1]), v("b2", b[2]);
  } else {
    v("r", r[0]), v("g", g[0]), v("b", b[0]);
  }
}

// vertices → triangle_setup. Either winding. Index 0 with three equal vertices is no triangle at all: it carries
// `last` for a frame without triangles.
template <class F>
struct Triangle {
  static constexpr const char* kStream = "triangle";
  Bit last;  // of the frame
  typename F::Index index;
  typename F::Object object;  // that the triangle is of; not 0
  typename F::Coord x[3], y[3];
  typename F::Depth depth[3];
  typename F::Colour r[3], g[3], b[3];  // flat: at [0]

  template <class V>
  void visit(V&& v) {
    v("last", last), v("index", index);
    if (F::kHasObjects) v("object", object);
    v("x0", x[0]), v("x1", x[1]), v("x2", x[2]);
    v("y0", y[0]), v("y1", y[1]), v("y2", y[2]);
    if (F::kHasDepth) v("depth0", depth[0]), v("depth1", depth[1]), v("depth2", depth[2]);
    if (F::kHasColours) visit_colours<F>(v, r, g, b);
  }
};

// triangle_setup → raster_pineda, one a triangle. Positions in stamps.
template <class F>
struct Setup {
  static constexpr const char* kStream = "setup";
  Bit last;
  Bit empty;  // no pixel centre of the frame lies in the bounding box, or the area is zero; the rest then means nothing
  typename F::Index index;
  typename F::X x_min, x_max, x_start;  // bounding box in the frame; where to look first in its top row
  typename F::Y y_min, y_max;
  // Edge functions at the centre of the first pixel of stamp (x_start, y_min): inside is >= 0 in all three.
  typename F::EdgeStep e[3];
  typename F::Delta e_dx[3], e_dy[3];  // steps of one pixel
  typename F::DepthPlane depth;        // at the same centre, ½ included
  typename F::DepthGradient depth_dx, depth_dy;

  template <class V>
  void visit(V&& v) {
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
  static constexpr const char* kStream = "attributes";
  Bit last;
  Bit empty;
  typename F::Index index;
  typename F::Coord x, y;  // vertex 0
  typename F::Delta dx1, dy1, dx2, dy2;
  typename F::Shift shift;
  typename F::Reciprocal reciprocal;
  // Where values of the vertices come later: which vertex, as given, vertex 0 is; and whether the other two follow it
  // backwards.
  VertexNumber first;
  Bit turned;
  typename F::Colour r[3], g[3], b[3];  // flat: at [0]

  template <class V>
  void visit(V&& v) {
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

// shade_setup → TdbS, the triangle database for shading: the entry of triangle `index`.
template <class F>
struct Planes {
  static constexpr const char* kStream = "planes";
  Bit last;
  Bit empty;  // nothing to store
  typename F::Index index;
  typename F::ColourPlane r;  // at the centre of pixel (0, 0) of the frame, ½ included; flat: the colour
  typename F::ColourGradient r_dx, r_dy;
  typename F::ColourPlane g;
  typename F::ColourGradient g_dx, g_dy;
  typename F::ColourPlane b;
  typename F::ColourGradient b_dx, b_dy;

  template <class V>
  void visit(V&& v) {
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
  static constexpr const char* kStream = "planes";
  Bit last;
  Bit empty;  // nothing to store
  typename F::Index index;
  typename F::MaterialNumber material;
  typename F::NormalPlane start[3];  // x, y, z at the centre of pixel (0, 0) of the frame, ½ included
  typename F::NormalGradient dx[3], dy[3];

  template <class V>
  void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index), v("material", material);
    v("x", start[0]), v("x_dx", dx[0]), v("x_dy", dy[0]);
    v("y", start[1]), v("y_dx", dx[1]), v("y_dy", dy[1]);
    v("z", start[2]), v("z_dx", dx[2]), v("z_dy", dy[2]);
  }
};

// geometry → texture_setup, with F::kHasTexture: of a visible triangle, for its vertices in the order given. With
// u′ = u less a whole number, the same for all three, and 0 <= u′ <= 2^e, v′ alike:
//
//   perspective   q = (2^b − 1)·w_least/w, rounded, 1 at least;  s = q·u′/2^e,  t = q·v′/2^e, rounded
//   affine        s = 2^b·u′/2^e,  t = 2^b·v′/2^e, rounded, 2^b − 1 at most
template <class F>
struct TextureCoordinates {
  static constexpr const char* kStream = "texture_coordinates";
  Bit last;
  typename F::Index index;
  typename F::TextureNumber texture;  // 0: none, and the rest means nothing
  typename F::Repeats repeats;        // e
  typename F::Coordinate s[3], t[3], q[3];

  template <class V>
  void visit(V&& v) {
    v("last", last), v("index", index), v("texture", texture), v("repeats", repeats);
    v("s0", s[0]), v("s1", s[1]), v("s2", s[2]);
    v("t0", t[0]), v("t1", t[1]), v("t2", t[2]);
    if (F::kPerspective) v("q0", q[0]), v("q1", q[1]), v("q2", q[2]);
  }
};

// texture_setup → TdbS, with F::kHasTexture: the entry of triangle `index`.
template <class F>
struct TexturePlanes {
  static constexpr const char* kStream = "texture_planes";
  Bit last;
  Bit empty;  // nothing to store
  typename F::Index index;
  typename F::TextureNumber texture;
  typename F::Repeats repeats;
  typename F::CoordinatePlane start[3];  // s, t, q at the centre of pixel (0, 0) of the frame, ½ included
  typename F::CoordinateGradient dx[3], dy[3];

  template <class V>
  void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index), v("texture", texture), v("repeats", repeats);
    v("s", start[0]), v("s_dx", dx[0]), v("s_dy", dy[0]);
    v("t", start[1]), v("t_dx", dx[1]), v("t_dy", dy[1]);
    if (F::kPerspective) v("q", start[2]), v("q_dx", dx[2]), v("q_dy", dy[2]);
  }
};

// The key frames: the one before a frame in between, and the one after it.
constexpr int kKeys = 2;

// Where a triangle of a frame in between is in a key frame. With a place (x, y) less the origin, u = (place −
// origin)/2^e in [0, 1]², and W = w of a vertex at the key over its w in between, for its vertices in the order given:
//
//   perspective   q = (2^b − 1)·W/W_most, rounded, 1 at least;  s = q·u_x,  t = q·u_y, rounded
//   affine        s = 2^b·u_x,  t = 2^b·u_y, rounded, 2^b − 1 at most
template <class F>
struct KeyPlaces {
  Bit there;  // the triangle has a place in the key frame; else the rest means nothing
  typename F::Origin origin_x, origin_y;
  typename F::Extent extent;  // e
  typename F::Coordinate s[3], t[3], q[3];
  typename F::Difference r[3], g[3],
      b[3];  // F::kRelights: colour in between less that at the key, plus 2^c, in units of 2^−d
};

// geometry → motion_setup, with F::kHasMotion, in answer to a Visible that says so.
template <class F>
struct MotionVectors {
  static constexpr const char* kStream = "motion_vectors";
  Bit last;
  typename F::Index index;
  typename F::Face face;
  KeyPlaces<F> key[kKeys];

  template <class V>
  void visit(V&& v) {
    v("last", last), v("index", index), v("face", face);
    visit_key(v, key[0], kNames[0]);
    visit_key(v, key[1], kNames[1]);
  }

 private:
  using Names = const char* const[22];
  static constexpr Names kNames[kKeys] = {
      {"there_0", "origin_x_0", "origin_y_0", "extent_0", "s0_0", "s1_0", "s2_0", "t0_0", "t1_0", "t2_0", "q0_0",
       "q1_0",    "q2_0",       "r0_0",       "r1_0",     "r2_0", "g0_0", "g1_0", "g2_0", "b0_0", "b1_0", "b2_0"},
      {"there_1", "origin_x_1", "origin_y_1", "extent_1", "s0_1", "s1_1", "s2_1", "t0_1", "t1_1", "t2_1", "q0_1",
       "q1_1",    "q2_1",       "r0_1",       "r1_1",     "r2_1", "g0_1", "g1_1", "g2_1", "b0_1", "b1_1", "b2_1"}};
  template <class V>
  static void visit_key(V&& v, KeyPlaces<F>& k, Names& n) {
    v(n[0], k.there), v(n[1], k.origin_x), v(n[2], k.origin_y), v(n[3], k.extent);
    v(n[4], k.s[0]), v(n[5], k.s[1]), v(n[6], k.s[2]);
    v(n[7], k.t[0]), v(n[8], k.t[1]), v(n[9], k.t[2]);
    if (F::kPerspective) v(n[10], k.q[0]), v(n[11], k.q[1]), v(n[12], k.q[2]);
    if (!F::kRelights) return;
    v(n[13], k.r[0]), v(n[14], k.r[1]), v(n[15], k.r[2]);
    v(n[16], k.g[0]), v(n[17], k.g[1]), v(n[18], k.g[2]);
    v(n[19], k.b[0]), v(n[20], k.b[1]), v(n[21], k.b[2]);
  }
};
template <class F>
constexpr typename MotionVectors<F>::Names MotionVectors<F>::kNames[kKeys];

// Planes of the same, each at the centre of pixel (0, 0) of the frame, ½ included.
template <class F>
struct KeyPlanes {
  Bit there;
  typename F::Origin origin_x, origin_y;
  typename F::Extent extent;
  typename F::CoordinatePlane start[3];  // s, t, q
  typename F::CoordinateGradient dx[3], dy[3];
  typename F::DifferencePlane colour[3];  // r, g, b
  typename F::DifferenceGradient colour_dx[3], colour_dy[3];
};

// motion_setup → TdbS, with F::kHasMotion: the entry of triangle `index`.
template <class F>
struct MotionPlanes {
  static constexpr const char* kStream = "motion_planes";
  Bit last;
  Bit empty;  // nothing to store
  typename F::Index index;
  typename F::Face face;
  KeyPlanes<F> key[kKeys];

  template <class V>
  void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index), v("face", face);
    visit_key(v, key[0], kNames[0]);
    visit_key(v, key[1], kNames[1]);
  }

 private:
  using Names = const char* const[22];
  static constexpr Names kNames[kKeys] = {
      {"there_0", "origin_x_0", "origin_y_0", "extent_0", "s_0",    "s_dx_0", "s_dy_0", "t_0",
       "t_dx_0",  "t_dy_0",     "q_0",        "q_dx_0",   "q_dy_0", "r_0",    "r_dx_0", "r_dy_0",
       "g_0",     "g_dx_0",     "g_dy_0",     "b_0",      "b_dx_0", "b_dy_0"},
      {"there_1", "origin_x_1", "origin_y_1", "extent_1", "s_1",    "s_dx_1", "s_dy_1", "t_1",
       "t_dx_1",  "t_dy_1",     "q_1",        "q_dx_1",   "q_dy_1", "r_1",    "r_dx_1", "r_dy_1",
       "g_1",     "g_dx_1",     "g_dy_1",     "b_1",      "b_dx_1", "b_dy_1"}};
  template <class V>
  static void visit_key(V&& v, KeyPlanes<F>& k, Names& n) {
    v(n[0], k.there), v(n[1], k.origin_x), v(n[2], k.origin_y), v(n[3], k.extent);
    v(n[4], k.start[0]), v(n[5], k.dx[0]), v(n[6], k.dy[0]);
    v(n[7], k.start[1]), v(n[8], k.dx[1]), v(n[9], k.dy[1]);
    if (F::kPerspective) v(n[10], k.start[2]), v(n[11], k.dx[2]), v(n[12], k.dy[2]);
    if (!F::kRelights) return;
    v(n[13], k.colour[0]), v(n[14], k.colour_dx[0]), v(n[15], k.colour_dy[0]);
    v(n[16], k.colour[1]), v(n[17], k.colour_dx[1]), v(n[18], k.colour_dy[1]);
    v(n[19], k.colour[2]), v(n[20], k.colour_dx[2]), v(n[21], k.colour_dy[2]);
  }
};
template <class F>
constexpr typename MotionPlanes<F>::Names MotionPlanes<F>::kNames[kKeys];

// A pixel of the motion buffer, in pixels of the frame in between: the face that it shows, and for each key frame the
// way from its centre to the place of the same point there.
template <class F>
struct KeyVector {
  Bit there;  // 0: the point has no place in the key frame, or the vector does not fit, and is 0
  typename F::Vector x, y;
  typename F::Difference r, g, b;  // F::kRelights: colour in between less that at the key, plus 2^c, in units of 2^−d
};

// motion_field → motion buffer → motion_compensate: a word a covered pixel. A frame whose last stamp covers nothing
// ends with a word of face 0.
template <class F>
struct Motion {
  static constexpr const char* kStream = "motion";
  Bit last;
  typename F::X x;  // in pixels
  typename F::Y y;
  typename F::Face face;
  KeyVector<F> key[kKeys];

  template <class V>
  void visit(V&& v) {
    v("last", last), v("x", x), v("y", y), v("face", face);
    v("there_0", key[0].there), v("vx_0", key[0].x), v("vy_0", key[0].y);
    if (F::kRelights) v("r_0", key[0].r), v("g_0", key[0].g), v("b_0", key[0].b);
    v("there_1", key[1].there), v("vx_1", key[1].x), v("vy_1", key[1].y);
    if (F::kRelights) v("r_1", key[1].r), v("g_1", key[1].g), v("b_1", key[1].b);
  }
};

// raster_pineda → ztest_plane, with F::kTestsPlanes alone: the depth plane of each triangle, as in its Setup, before
// its first stamp. Of an empty triangle it means nothing.
template <class F>
struct TriangleDepth {
  static constexpr const char* kStream = "triangle_depth";
  typename F::Index index;
  typename F::X x;  // the stamp whose first pixel the plane starts at
  typename F::Y y;
  typename F::DepthPlane depth;
  typename F::DepthGradient depth_dx, depth_dy;

  template <class V>
  void visit(V&& v) {
    v("index", index), v("x", x), v("y", y);
    v("depth", depth), v("depth_dx", depth_dx), v("depth_dy", depth_dy);
  }
};

// raster_pineda → the Z-test, ztest_index or ztest_plane: a stamp with a covered pixel. A triangle that covers none
// sends one with an empty mask, for the end of the triangle.
template <class F>
struct Stamp {
  static constexpr const char* kStream = "stamp";
  Bit mask[F::kLanes];
  typename F::Depth depth[F::kLanes];  // of the plane, also where the mask is 0 and it means nothing
  Bit last;                            // of the frame
  Bit triangle_last;                   // of the triangle
  typename F::Index index;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  void visit(V&& v) {
    v("last", last), v("triangle_last", triangle_last), v("index", index), v("x", x), v("y", y);
    v.lanes("mask", mask);
    if (F::kHasDepth) v.lanes("depth", depth);
  }
};

// What the stamps of a triangle cost ztest_plane: cycles, and entries of TdbV that it reads.
struct PlaneTests {
  int cycles, entries;
};

// The Z-test → I-buffer and Z-buffer, if there is one: a write, of a stamp of which a fragment passed.
template <class F>
struct Update {
  static constexpr const char* kStream = "update";
  Bit mask[F::kLanes];  // lanes that passed
  typename F::Depth depth[F::kLanes];
  typename F::Index index;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  void visit(V&& v) {
    v("index", index), v("x", x), v("y", y);
    v.lanes("mask", mask);
    if (F::kStoresDepth) v.lanes("depth", depth);
  }
};

// The Z-test → geometry: a triangle is done, and a fragment of it passed or none did.
template <class F>
struct Visible {
  static constexpr const char* kStream = "visible";
  Bit last;
  Bit visible;
  typename F::Index index;

  template <class V>
  void visit(V&& v) {
    v("last", last), v("visible", visible), v("index", index);
  }
};

// scan_index → shade_gouraud, or shade_phong: a stamp of the finished I-buffer, rows downward, stamps to the right.
template <class F>
struct Scan {
  static constexpr const char* kStream = "scan";
  typename F::Index index[F::kLanes];  // lanes outside the frame: 0
  Bit last;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  void visit(V&& v) {
    v("last", last), v("x", x), v("y", y);
    v.lanes("index", index);
  }
};

// The shader → frame, in the order of scan.
template <class F>
struct Pixel {
  static constexpr const char* kStream = "pixel";
  typename F::Colour r[F::kLanes], g[F::kLanes], b[F::kLanes];
  Bit last;
  typename F::X x;  // in stamps
  typename F::Y y;

  template <class V>
  void visit(V&& v) {
    v("last", last), v("x", x), v("y", y);
    v.lanes("r", r), v.lanes("g", g), v.lanes("b", b);
  }
};

// The shader → shade_texture, with F::kHasTexture: what the pixels look like without their texture.
template <class F>
struct LitPixel : Pixel<F> {
  static constexpr const char* kStream = "lit";
};

// An entry of the table of textures: sides of 2^log2_width and 2^log2_height texels. The base is a multiple of their
// product, so that it need not be added to what is below.
template <class F>
struct TextureEntry {
  static constexpr const char* kStream = "texture";
  typename F::TextureNumber texture;  // 1 … F::kTextures
  typename F::TexelAddress base;
  typename F::Side log2_width, log2_height;

  template <class V>
  void visit(V&& v) {
    v("texture", texture), v("base", base), v("log2_width", log2_width), v("log2_height", log2_height);
  }
};

// A word of the texture memory. Texel (i, j) of a texture of width 2^n has the address base + j·2^n + i; with
// F::kBilinear, in four banks, base + ((j div 2)·2^(n−1) + i div 2)·4 + (j mod 2)·2 + i mod 2: both sides are 2 or
// more, and the bank comes last.
template <class F>
struct Texel {
  static constexpr const char* kStream = "texel";
  typename F::TexelAddress address;
  typename F::Colour r, g, b;

  template <class V>
  void visit(V&& v) {
    v("address", address), v("r", r), v("g", g), v("b", b);
  }
};

// A light of the frame: unit vectors to it and, for highlights, half-way between it and the viewer.
template <class F>
struct Light {
  static constexpr const char* kStream = "light";
  typename F::LightNumber light;
  typename F::Direction to_light[3], half[3];

  template <class V>
  void visit(V&& v) {
    v("light", light);
    v("x", to_light[0]), v("y", to_light[1]), v("z", to_light[2]);
    if (F::kHasGloss) v("half_x", half[0]), v("half_y", half[1]), v("half_z", half[2]);
  }
};

// What a material makes of a light, in LSB of the colour. The bases of a material's lights add up to what it has
// without any.
template <class F>
struct Material {
  static constexpr const char* kStream = "material";
  typename F::MaterialNumber material;
  typename F::LightNumber light;
  typename F::Gloss gloss;  // k: the exponent is 2^k; the same for all lights
  typename F::Coefficient base[3], diffuse[3], specular[3];

  template <class V>
  void visit(V&& v) {
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
  static constexpr const char* kStream = "normals";
  Bit last;
  typename F::Index index;
  typename F::MaterialNumber material;
  typename F::Normal x[3], y[3], z[3];  // flat: one, at [0]

  template <class V>
  void visit(V&& v) {
    v("last", last), v("index", index), v("material", material);
    v("x0", x[0]), v("y0", y[0]), v("z0", z[0]);
    if (F::kShadesPlanes) v("x1", x[1]), v("y1", y[1]), v("z1", z[1]), v("x2", x[2]), v("y2", y[2]), v("z2", z[2]);
  }
};

// light_vertex → shade_setup: the colours of a triangle.
template <class F>
struct Colours {
  static constexpr const char* kStream = "colours";
  Bit last;
  typename F::Index index;
  typename F::Colour r[3], g[3], b[3];  // flat: at [0]

  template <class V>
  void visit(V&& v) {
    v("last", last), v("index", index);
    visit_colours<F>(v, r, g, b);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_HPP_
