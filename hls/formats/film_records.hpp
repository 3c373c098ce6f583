// SPDX-License-Identifier: Apache-2.0
// The records of films, with F::kUpConverts: frames between two key frames, and the pixels of both. All places are in
// pixels.
#ifndef HALFSPACE_HLS_FORMATS_FILM_RECORDS_HPP_
#define HALFSPACE_HLS_FORMATS_FILM_RECORDS_HPP_

#include "hls/formats/key_records.hpp"

namespace halfspace {

// What a frame of triangles is drawn for.
enum class Pass {
  kKey,      // a key frame: shaded, and stored
  kBetween,  // a frame in between: its motion, and the colours that it finds in the key frames
  kFill,     // what that left: the triangles that holes show, shaded there alone
};

// Whether the triangles of a pass come with motion; else with what they are shaded by.
template <class F>
bool moves(Pass pass) {
  return F::kHasMotion && (!F::kShades || pass == Pass::kBetween);
}
// The pass of a frame that is no film's.
template <class F>
Pass only_pass() {
  return F::kShades ? Pass::kKey : Pass::kBetween;
}

// pixel_store → key memory, or film buffer: a pixel of the frame.
template <class F>
struct ShownPixel {
  typename F::Bit last;
  typename F::X x;
  typename F::Y y;
  typename F::Bit shown;  // a triangle; else the background
  typename F::Face face;  // of that triangle; 0: the background
  typename F::Colour r, g, b;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y), v("shown", shown), v("face", face);
    v("r", r), v("g", g), v("b", b);
  }
};

// hole_find → geometry: a face of a frame in between that a pixel shows which no key shows. One that comes twice is
// asked for once more. Geometry answers the last word by a pass with all triangles of these faces, in the order of the
// frame; or, if it is of face 0, and so alone, by the next frame.
template <class F>
struct Asked {
  typename F::Bit last;
  typename F::Face face;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("face", face);
  }
};

// film_scan → frame.
template <class F>
struct FilmPixel {
  typename F::Bit last;
  typename F::X x;
  typename F::Y y;
  typename F::Colour r, g, b;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y), v("r", r), v("g", g), v("b", b);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_FILM_RECORDS_HPP_
