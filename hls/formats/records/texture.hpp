// SPDX-License-Identifier: Apache-2.0
// The records of room texture.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_TEXTURE_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_TEXTURE_HPP_

#include "hls/formats/records/frame.hpp"

namespace halfspace {

// geometry → texture_setup, with F::kHasTexture: of a visible triangle, for its vertices in the order given. With
// u′ = u less a whole number, the same for all three, and 0 <= u′ <= 2^e, v′ alike:
//
//   perspective   q = (2^b − 1)·w_least/w, rounded, 1 at least;  s = q·u′/2^e,  t = q·v′/2^e, rounded
//   affine        s = 2^b·u′/2^e,  t = 2^b·v′/2^e, rounded, 2^b − 1 at most
template <class F>
struct TextureCoordinates {
  typename F::Bit last;
  typename F::Index index;
  typename F::TextureNumber texture;  // 0: none, and the rest means nothing
  typename F::Repeats repeats;        // e
  typename F::Coordinate s[3], t[3], q[3];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("index", index), v("texture", texture), v("repeats", repeats);
    v("s0", s[0]), v("s1", s[1]), v("s2", s[2]);
    v("t0", t[0]), v("t1", t[1]), v("t2", t[2]);
    if (F::kPerspective) v("q0", q[0]), v("q1", q[1]), v("q2", q[2]);
  }
};

// texture_setup → TdbS, with F::kHasTexture: the entry of triangle `index`.
template <class F>
struct TexturePlanes {
  typename F::Bit last;
  typename F::Bit empty;  // nothing to store
  typename F::Index index;
  typename F::TextureNumber texture;
  typename F::Repeats repeats;
  typename F::CoordinatePlane start[3];  // s, t, q at the centre of pixel (0, 0) of the frame, ½ included
  typename F::CoordinateGradient dx[3], dy[3];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index), v("texture", texture), v("repeats", repeats);
    v("s", start[0]), v("s_dx", dx[0]), v("s_dy", dy[0]);
    v("t", start[1]), v("t_dx", dx[1]), v("t_dy", dy[1]);
    if (F::kPerspective) v("q", start[2]), v("q_dx", dx[2]), v("q_dy", dy[2]);
  }
};

// An entry of the table of textures: sides of 2^log2_width and 2^log2_height texels. The base is a multiple of their
// product, so that it need not be added to what is below.
template <class F>
struct TextureEntry {
  typename F::TextureNumber texture;  // 1 … F::kTextures
  typename F::TexelAddress base;
  typename F::Side log2_width, log2_height;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("texture", texture), v("base", base), v("log2_width", log2_width), v("log2_height", log2_height);
  }
};

// A word of the texture memory. Texel (i, j) of a texture of width 2^n has the address base + j·2^n + i; with
// F::kBilinear, in four banks, base + ((j div 2)·2^(n−1) + i div 2)·4 + (j mod 2)·2 + i mod 2: both sides are 2 or
// more, and the bank comes last.
template <class F>
struct Texel {
  typename F::TexelAddress address;
  typename F::Colour r, g, b;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("address", address), v("r", r), v("g", g), v("b", b);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_TEXTURE_HPP_
