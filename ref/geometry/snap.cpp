// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/snap.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ref/error.hpp"

namespace halfspace::ref {
namespace {

// Why the list is beyond the format; empty when it is not.
std::string misfit(const TriangleList& list, const RasterFormat& format) {
  if (list.width < 1 || list.height < 1 || list.width > format.width || list.height > format.height) {
    return fmt::format("the frame of {}x{} pixels does not fit configuration {}, which takes 1x1 to {}x{}", list.width,
                       list.height, format.name, format.width, format.height);
  }
  if (list.triangles.size() > static_cast<std::size_t>(format.triangles)) {
    return fmt::format("the {} triangles do not fit configuration {}, which takes {}", list.triangles.size(),
                       format.name, format.triangles);
  }
  const double limit = std::ldexp(1.0, format.range_bits - 1 + format.subpixel_bits);
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    for (int v = 0; v < 3; ++v) {
      const Vertex& vertex = list.triangles[k][v];
      for (const auto& [axis, pixels] : {std::pair('x', vertex.x), std::pair('y', vertex.y)}) {
        const double position = snapped_position(pixels, format.subpixel_bits);
        if (position >= -limit && position < limit) continue;
        return fmt::format("triangle {}, vertex {}: {} = {} does not fit configuration {}, which takes [{}, {}) pixels",
                           k + 1, v, axis, pixels, format.name, -(1 << (format.range_bits - 1)),
                           1 << (format.range_bits - 1));
      }
    }
  }
  return {};
}

std::string remedy(const TriangleList& list, const std::vector<RasterFormat>& others) {
  for (const RasterFormat& other : others) {
    if (misfit(list, other).empty()) return fmt::format("configuration {} takes it", other.name);
  }
  if (others.empty()) return "take a larger configuration";
  return "no configuration takes it, so make the frame or the scene smaller";
}

}  // namespace

// Scaling by 2^f is exact, so there is one rounding, in the mode the program starts in: to nearest, ties to
// even.
double snapped_position(double pixels, int subpixel_bits) { return std::nearbyint(std::ldexp(pixels, subpixel_bits)); }

std::uint8_t snapped_colour(double value, int bits) {
  return static_cast<std::uint8_t>(std::round(value * (full_depth(bits) / 255.0)));
}

SnappedList snap(const TriangleList& list, const RasterFormat& format, const std::vector<RasterFormat>& others) {
  const std::string reason = misfit(list, format);
  if (!reason.empty()) throw Misfit(reason + "; " + remedy(list, others));

  SnappedList snapped{format, list.width, list.height, {}, {}};
  for (int c = 0; c < 3; ++c) snapped.background[c] = snapped_colour(list.background[c], format.colour_bits);
  snapped.triangles.reserve(list.triangles.size());
  for (const auto& triangle : list.triangles) {
    SnappedTriangle& s = snapped.triangles.emplace_back();
    for (int v = 0; v < 3; ++v) {
      const Vertex& vertex = triangle[v];
      s.x[v] = static_cast<std::int32_t>(snapped_position(vertex.x, format.subpixel_bits));
      s.y[v] = static_cast<std::int32_t>(snapped_position(vertex.y, format.subpixel_bits));
      s.depth[v] = static_cast<std::uint32_t>(std::round(vertex.z * full_depth(format.depth_bits)));
      const int bits = format.colour_bits;
      s.rgb[v] = {snapped_colour(vertex.r, bits), snapped_colour(vertex.g, bits), snapped_colour(vertex.b, bits)};
    }
  }
  return snapped;
}

// Positions are dyadic, so exact. A depth d / (2^b - 1) has a relative error of 2^-53, which times 2^b is far
// from ½.
TriangleList unsnap(const SnappedList& list) {
  TriangleList out{list.width, list.height, {}, {}};
  for (int c = 0; c < 3; ++c) out.background[c] = list.background[c] * (255.0 / full_depth(list.format.colour_bits));
  const double full = full_depth(list.format.depth_bits), colour = 255.0 / full_depth(list.format.colour_bits);
  const int f = list.format.subpixel_bits;
  out.triangles.reserve(list.triangles.size());
  for (const SnappedTriangle& s : list.triangles) {
    auto& triangle = out.triangles.emplace_back();
    for (int v = 0; v < 3; ++v) {
      triangle[v] = {std::ldexp(s.x[v], -f), std::ldexp(s.y[v], -f), full == 0 ? 0 : s.depth[v] / full,
                     s.rgb[v][0] * colour,   s.rgb[v][1] * colour,   s.rgb[v][2] * colour};
    }
  }
  return out;
}

}  // namespace halfspace::ref
