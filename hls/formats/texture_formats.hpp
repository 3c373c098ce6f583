// SPDX-License-Identifier: Apache-2.0
// The widths of texture: coordinates, the division by q, addresses, the filter.
#ifndef HALFSPACE_HLS_FORMATS_TEXTURE_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_TEXTURE_FORMATS_HPP_

#include "hls/formats/format_table.hpp"

namespace halfspace {

// y of reciprocal_lookup, in (½, 1).
constexpr int kInverseFraction = 20;
// A triangle spans 2^e repetitions of its texture at most, each way.
constexpr int kRepeatBits = 4;
// Fraction bits of the place of a pixel among texels: the weights of a bilinear filter. And those that the filtered
// texel keeps: half of its last place is 2^−9 LSB of the picture.
constexpr int kWeightBits = 8, kFilteredFraction = 8;

// b of coordinates, idle without.
constexpr int coordinate_channel_bits(const Config& c) { return has_coordinates(c) ? c.coordinate_bits : 10; }

// The numbers of texture; without it no record carries one, and the types are idle.
constexpr FormatTable texture_formats(const Config& c, FormatTable t) {
  const int b = coordinate_channel_bits(c), memory = has_texture(c) ? exact_log2(c.texels) : 2;
  // log2 of the longest side: the other has one texel, or two in banks.
  const int side = is_bilinear(c) ? memory - 1 : memory;
  // 0: none; 1 … textures.
  t.texture = {bits_for(c.textures), bits_for(c.textures), false};
  t.repeats = {kRepeatBits, kRepeatBits, false};
  t.side = {bits_for(side), bits_for(side), false};
  t.texel_address = {memory, memory, false};
  t.inverse = {kInverseFraction, 0, false};
  t.inverse_shift = {bits_for(b - 1), bits_for(b - 1), false};  // leading zeros of q >= 1
  t.texel_place = {side + kWeightBits, side, false};            // in texels, modulo the side
  t.filtered = {c.colour_bits + kFilteredFraction, c.colour_bits, false};
  return t;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_TEXTURE_FORMATS_HPP_
