// SPDX-License-Identifier: Apache-2.0
// The cycles of the RTL's triangle setup, which a configuration decides.
#ifndef HALFSPACE_HLS_FORMATS_SETUP_INTERVAL_HPP_
#define HALFSPACE_HLS_FORMATS_SETUP_INTERVAL_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

// Cycles that hs_plane_setup takes for the depth plane of a triangle, from its record to the plane: eight products on
// one multiplier, each by a distance or by the reciprocal in chunks of 17 bits, and three cycles from a product to its
// sum.
constexpr int depth_plane_latency(const Config& c) {
  const int chunk = 17, to_sum = 3;
  const int by_distance = 2 * ((c.range_bits + c.subpixel_bits + chunk - 1) / chunk);
  const int by_reciprocal = (c.reciprocal_bits + 1 + chunk - 1) / chunk;
  const int gradient_x = max_of(2 * by_distance, by_distance + to_sum);  // N_A is known, and N_B issued
  const int gradient_y = max_of(gradient_x + by_reciprocal, 2 * by_distance + to_sum);
  return gradient_y + by_reciprocal + to_sum + by_distance + to_sum;
}

// Cycles at least that the RTL's triangle setup takes for a triangle that is not empty: those of the slowest of three
// units that work on three triangles at once. The edges take 14, one of them to hand D to the divider, and one more
// where the vertices come with D < 0; the division a quotient bit a cycle, and one to load it; a depth plane leaves
// before the next one is begun.
constexpr int setup_interval(const Config& c) {
  const int edges = has_planes(c) ? 14 : 13;
  const int division = has_planes(c) ? c.reciprocal_bits + 3 : 0;
  const int depth = has_depth(c) ? depth_plane_latency(c) + 1 : 0;
  return max_of(max_of(edges, division), depth);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_SETUP_INTERVAL_HPP_
