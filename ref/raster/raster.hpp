// SPDX-License-Identifier: Apache-2.0
// The reference rasterizer: what index rendering has to come to, decided without an error of arithmetic.
//
// Coverage is Pineda's edge functions in integers with the top-left rule; either winding is drawn. Depth and
// colour are planes over the snapped vertices, kept as exact rationals until the last step. Visibility is
// decided first, into index and depth; colour is taken at scan-out from the triangle whose index stands in
// the pixel.
#ifndef HALFSPACE_REF_RASTER_RASTER_HPP_
#define HALFSPACE_REF_RASTER_RASTER_HPP_

#include <array>
#include <cstdint>
#include <vector>

#include "ref/geometry/snap.hpp"

namespace halfspace::ref {

// width * height pixels, row 0 on top.
struct Frame {
  int width, height;
  std::vector<std::uint32_t> index;                 // 0 background, k the k-th triangle
  std::vector<std::uint32_t> depth;                 // background 2^b - 1; without depth 0 everywhere
  std::vector<std::array<std::uint8_t, 4>> colour;  // r, g, b, 255
  // Of the triangle that is visible, before rounding; colours of 0 … 255.
  std::vector<double> exact_depth;
  std::vector<std::array<double, 3>> exact_colour;
  std::vector<bool> visible;  // triangle k at [k - 1]: has a fragment passed the test when it was drawn?
};

// Depth test less, so that the first drawn wins a tie and a fragment at 2^b - 1 never passes. Without depth the first
// drawn wins each pixel.
Frame render(const SnappedList&);

// Is the centre of pixel (px, py) in the triangle? Positions below 2^30 in magnitude, the pixel's too.
bool covers(const SnappedTriangle&, int subpixel_bits, int px, int py);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_RASTER_RASTER_HPP_
