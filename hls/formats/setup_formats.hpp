// SPDX-License-Identifier: Apache-2.0
// The widths of positions, areas, edge functions and planes: what the setup of triangles and the Z-test compute with.
#ifndef HALFSPACE_HLS_FORMATS_SETUP_FORMATS_HPP_
#define HALFSPACE_HLS_FORMATS_SETUP_FORMATS_HPP_

#include "hls/formats/format_table.hpp"

namespace halfspace {

constexpr FormatTable setup_formats(const Config& c, FormatTable t) {
  const int f = c.subpixel_bits;
  // Frame sizes 1 … width, and pixel coordinates. The same width whatever the stamp.
  t.x = {bits_for(c.width), bits_for(c.width), false};
  t.y = {bits_for(c.height), bits_for(c.height), false};
  // 0 is the background, so N triangles need N + 1 values.
  t.index = {bits_for(c.triangles), bits_for(c.triangles), false};
  // Triangles whose results index_pool has not read yet: as many as its window at most.
  t.flight = {bits_for(c.index_window), bits_for(c.index_window), false};

  // A position: range_bits before the point, the sign among them; c bits in all.
  t.coord = {c.range_bits + f, c.range_bits, true};
  // |x1 − x0| < 2^c units: one bit more than a position.
  t.delta = {t.coord.width + 1, c.range_bits + 1, true};
  // Twice the area of a triangle within a square of side s is at most s²: |D| < 2^(2c).
  t.area = {2 * t.coord.width, 2 * c.range_bits, false};
  t.signed_area = {t.area.width + 1, t.area.integer + 1, true};
  // Twice the area of (vertex, vertex, pixel centre), less the tie bias of one: [−2^(2c), 2^(2c)).
  t.edge = {t.area.width + 1, t.area.integer + 1, true};
  // Steps are multiples of 2^f units, so the low f bits never change, and the sign of a number is the sign of its
  // floor: they are dropped once the bias is folded in.
  t.edge_step = {t.edge.width - f, t.edge.integer, true};
  // R = round(2^(r+s) / D) with 2^s <= D < 2^(s+1): 2^(r−1) <= R <= 2^r.
  t.reciprocal = {c.reciprocal_bits + 1, 1, false};
  // s = floor(log2 D): 0 … 2c − 1.
  t.shift = {bits_for(t.area.width - 1), bits_for(t.area.width - 1), false};
  return t;
}

// What plane_setup takes and gives.
struct ChannelFormats {
  NumberFormat value, plane, gradient, numerator, start, start_gradient;
};

// Of a channel of b bits whose gradients have g fraction bits.
constexpr ChannelFormats channel_formats(const Config& config, int b, int g) {
  const int f = config.subpixel_bits, c = config.range_bits + f;
  ChannelFormats t{};
  t.value = {b, b, false};
  // A plane is kept modulo 2^b: at a covered pixel centre its value, less the error, lies between values of the
  // vertices, and the error is below ½ (see refusal), so the rounded value is one of 0 … 2^b − 1.
  t.plane = {b + g, b, false};
  t.gradient = {b + g, b, true};
  // N = dv1·dy2 − dv2·dy1 = v1·dy2 − v2·dy1 + v0·(dy1 − dy2): each v is in [0, 2^b), and the three factors sum to zero,
  // so N is at most 2^b times their positive part, a distance between two vertices: |N| < 2^(b+c).
  t.numerator = {b + c + 1, b + config.range_bits + 1, true};
  // The start of a plane lies a multiple of 2^−f pixels from vertex 0: it is summed with f + g fraction bits, modulo
  // 2^b, and takes the gradients modulo 2^(b+f).
  t.start = {b + g + f, b, true};
  t.start_gradient = {b + g + f, b + f, true};
  return t;
}

// b of depth. Without it no record carries a depth, and its types are idle.
constexpr int depth_channel_bits(const Config& c) { return has_depth(c) ? c.depth_bits : 1; }

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_SETUP_FORMATS_HPP_
