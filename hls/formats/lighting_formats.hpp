// SPDX-License-Identifier: Apache-2.0
// The widths of lighting: vectors, the length of a normal, cosines, coefficients and the sum of a light.
#ifndef HALFSPACE_HLS_FORMATS_LIGHTING_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_LIGHTING_FORMATS_HPP_

#include "hls/formats/format_table.hpp"

namespace halfspace {

// A coefficient of a material, in LSB of the colour: 2^kCoefficientHead times full scale, so that a light brighter than
// white is no more than clamped where it shines; kCoefficientFraction bits are 1/128 LSB of rounding at most.
constexpr int kCoefficientHead = 2, kCoefficientFraction = 6;
// y of reciprocal_sqrt, in (½, 1).
constexpr int kRootFraction = 18;
// u: fraction bits of a cosine. An exponent of 16 makes 16 times its error, so that 2^−(b+8) becomes 2^−4 LSB.
constexpr int cosine_fraction(const Config& c) { return c.colour_bits + 8; }

// p, idle without lighting.
constexpr int lit_normal_bits(const Config& c) { return has_lighting(c) ? c.normal_bits : 9; }
// b of normals. A component plus 2^p units is a whole number without a sign, as the other channels are, and the top bit
// inverted is all that takes.
constexpr int normal_channel_bits(const Config& c) { return lit_normal_bits(c) + 1; }

// The numbers of lighting; without it no record carries one, and the types are idle.
constexpr FormatTable lighting_formats(const Config& c, FormatTable t) {
  const int p = lit_normal_bits(c), lights = has_lighting(c) ? c.lights : 1;
  const int u = cosine_fraction(c);
  t.material = {bits_for(c.materials - 1), bits_for(c.materials - 1), false};
  t.light = {bits_for(lights - 1), bits_for(lights - 1), false};
  // Squarings: 0 … log2 of the largest exponent.
  t.gloss = {bits_for(exact_log2(c.gloss)), bits_for(exact_log2(c.gloss)), false};
  // A normal has any length, so that a component never needs the value 1; nor, but for half a last place, has a unit
  // vector of p + 1 bits. Directions are unit vectors; u + 2 bits of them, 18, are a factor of an FPGA's multiplier.
  t.normal = {p + 1, 1, true};
  t.direction = {u + 2, 1, true};
  // At most 3·(2^p)² < 2^(2p+2) units, an even number of bits: its root is shifted by half as many places.
  t.squared_length = {2 * p + 2, 2, false};
  t.root = {kRootFraction, 0, false};
  t.root_shift = {bits_for(p), bits_for(p), false};  // 0 … p
  // n·L, exact: at most 3·2^p·2^(u+1) < 2^(p+u+3) units.
  t.dot = {p + u + 4, 3, true};
  // The part of n·L above 0, with n normalized to 1 <= |n| < 2, so that it is below 2 but for what a direction is too
  // long.
  t.projection = {u + 1, 1, false};
  t.cosine = {u + 1, 1, false};  // 0 … 1
  t.coefficient = {c.colour_bits + kCoefficientHead + kCoefficientFraction, c.colour_bits + kCoefficientHead, false};
  // Exact: base, diffuse and specular of each light, times 1 at most.
  const int head = t.coefficient.integer + bits_for((has_gloss(c) ? 3 : 2) * lights);
  t.light_sum = {head + kCoefficientFraction + u, head, false};
  return t;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_LIGHTING_FORMATS_HPP_
