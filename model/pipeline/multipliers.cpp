// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/multipliers.hpp"

#include <algorithm>

namespace halfspace::model {
namespace {

constexpr int kChunk = 17;  // of a factor that comes in several

// hs_plane_setup: |N| < 2^(value + coordinate), and a gradient that has the bits of the start.
std::uint64_t plane_setup(int value_bits, int fraction, int coordinate_bits, int subpixel_bits) {
  const int wide = std::max(value_bits + coordinate_bits + 1, value_bits + fraction + subpixel_bits);
  return std::uint64_t(wide) * (kChunk + 1);
}

}  // namespace

std::optional<std::uint64_t> multiplier_bits(const Config& c) {
  if (has_lighting(c) || has_texture(c) || has_motion(c)) return std::nullopt;
  const int coordinate = c.range_bits + c.subpixel_bits, distance = coordinate + 1;
  const int x = bits_for(c.width - 1) + 1, y = bits_for(c.height - 1) + 1;
  std::uint64_t bits = std::uint64_t(distance) * distance;
  if (has_depth(c)) {
    bits += plane_setup(c.depth_bits, c.depth_fraction, coordinate, c.subpixel_bits);
    if (c.architecture == Architecture::kGamma) bits += std::uint64_t(c.depth_bits + c.depth_fraction) * (x + y);
  }
  if (is_gouraud(c)) {
    bits += plane_setup(c.colour_bits, c.colour_fraction, coordinate, c.subpixel_bits);
    bits += 3 * std::uint64_t(c.colour_bits + c.colour_fraction) * (x + y);
  }
  return bits;
}

}  // namespace halfspace::model
