// SPDX-License-Identifier: Apache-2.0
// What all records are made of, and a frame's registers.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_FRAME_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_FRAME_HPP_

#include "hls/formats/formats.hpp"

namespace halfspace {

using Bit = FlagFormats<Fixed>::Bit;
using VertexNumber = FlagFormats<Fixed>::VertexNumber;

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
HS_INLINE constexpr void visit_colours(V&& v, typename F::Colour (&r)[3], typename F::Colour (&g)[3],
                                       typename F::Colour (&b)[3]) {
  if (F::kGouraud) {
    v("r0", r[0]), v("r1", r[1]), v("r2", r[2]);
    v("g0", g[0]), v("g1", g[1]), v("g2", g[2]);
    v("b0", b[0]), v("b1", b[1]), v("b2", b[2]);
  } else {
    v("r", r[0]), v("g", g[0]), v("b", b[0]);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_FRAME_HPP_
