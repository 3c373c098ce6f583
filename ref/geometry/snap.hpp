// SPDX-License-Identifier: Apache-2.0
// From double to the integers that the rasterizer works on.
#ifndef HALFSPACE_REF_GEOMETRY_SNAP_HPP_
#define HALFSPACE_REF_GEOMETRY_SNAP_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ref/geometry/triangle_list.hpp"

namespace halfspace::ref {

// The triangles that a rasterizer drops by the sign of their area: those seen from behind, which come clockwise on the
// screen, or those seen from the front.
enum class Cull { kNone, kBack, kFront };

// What a hardware configuration takes; filled by the caller, as this folder knows none.
struct RasterFormat {
  std::string name;
  int width, height;    // largest frame, pixels
  int triangles;        // triangles a frame
  int range_bits;       // positions lie in [-2^(range_bits-1), 2^(range_bits-1)) pixels
  int subpixel_bits;    // f, fraction bits of a position, 1 or more
  int depth_bits;       // b, bits of a depth, 32 or less; 0: no depth, the first drawn wins
  int colour_bits = 8;  // bits of a channel, 8 or less
  bool flat = false;    // a triangle has the colour of its vertex 0
  Cull cull = Cull::kNone;
};

struct SnappedTriangle {
  std::array<std::int32_t, 3> x, y;  // f fraction bits
  std::array<std::uint32_t, 3> depth;
  std::array<std::array<std::uint8_t, 3>, 3> rgb;  // [vertex][channel], of colour_bits
};

struct SnappedList {
  RasterFormat format;
  int width, height;
  std::array<std::uint8_t, 3> background;  // of colour_bits
  std::vector<SnappedTriangle> triangles;
};

// 2^b - 1: the depth of the background; 0 without depth.
constexpr std::uint32_t full_depth(int depth_bits) {
  return static_cast<std::uint32_t>((std::uint64_t(1) << depth_bits) - 1);
}

// A channel of `bits` as the 0 … 255 of a picture.
constexpr std::uint8_t displayed_colour(unsigned value, int bits) {
  const unsigned full = (1u << bits) - 1;
  return static_cast<std::uint8_t>(bits == 8 ? value : (value * 255 + full / 2) / full);
}

// The centre of a pixel, a column or a row, in units of 2^-f pixels.
constexpr std::int64_t pixel_centre(std::int64_t pixel, int subpixel_bits) {
  const std::int64_t one = std::int64_t(1) << subpixel_bits;
  return pixel * one + one / 2;
}

// A position in units of 2^-f pixels, ties to even, still a double as it may be beyond any integer.
double snapped_position(double pixels, int subpixel_bits);

// A channel of 0 … 255 as `bits` of the hardware.
std::uint8_t snapped_colour(double value, int bits);

// Misfit when the frame, the number of triangles or a position is beyond `format`; it names the first of
// `others` that takes the list.
SnappedList snap(const TriangleList&, const RasterFormat&, const std::vector<RasterFormat>& others = {});

// snap(unsnap(s)) is s, but for depths that a format without depth has not.
TriangleList unsnap(const SnappedList&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_SNAP_HPP_
