// SPDX-License-Identifier: Apache-2.0
// The ideal picture: what a frame comes to without snapping, without rounding and without a guard band.
//
// A pixel shows the triangle that is nearest at its centre. Positions stand on a grid of 2^-44 pixels, as fine as the
// doubles that the geometry computes from 256 pixels on; on it coverage is exact, with the top-left rule, so that no
// centre on a shared edge is lost or drawn twice. Depth and colour are weighted means of the vertices, in double: the
// weights are exact edge functions, none negative, so nothing cancels, on slivers neither.
#ifndef HALFSPACE_REF_RASTER_IDEAL_HPP_
#define HALFSPACE_REF_RASTER_IDEAL_HPP_

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "ref/geometry/geometry.hpp"
#include "ref/geometry/triangle_list.hpp"

namespace halfspace::ref {

constexpr int kIdealSubpixelBits = 44;
constexpr int kIdealRangeBits = 18;  // clipped beyond ±131,072 pixels

// What to project a scene with for its ideal picture.
constexpr View ideal_view(int width, int height, double shift_x = 0, double shift_y = 0) {
  return {width, height, kIdealRangeBits, kIdealSubpixelBits, shift_x, shift_y};
}

// width * height pixels, row 0 on top.
struct IdealFrame {
  int width, height;
  std::vector<std::uint32_t> face;            // 0 background, else the number of a face of the scene
  std::vector<double> depth;                  // [0, 1]; background 1
  std::vector<std::array<double, 3>> colour;  // r, g, b, 0-255
};

// The number of the face that triangle `index` (from 1 on) of the list is a part of; 0 for 0.
std::uint32_t face_of(const TriangleList&, std::uint32_t index);

// The colour, 0-255, of triangle `k` (from 1 on) at a point of the frame, where its vertices in the order given weigh
// so much, 1 together. A pixel after another of a triangle in a row.
using IdealShade = std::function<std::array<double, 3>(std::uint32_t k, const std::array<double, 3>& weights)>;

// Depth test less: the first drawn wins a tie, and what lies at depth 1 is not seen. Without `shade` the colours of the
// vertices are mixed. Error when a position is beyond the range.
IdealFrame ideal(const TriangleList&, const IdealShade& shade = nullptr);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_RASTER_IDEAL_HPP_
