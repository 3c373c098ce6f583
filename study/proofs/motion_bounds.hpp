// SPDX-License-Identifier: Apache-2.0
// How far off a vector of the motion field may be, an axis, in pixels. docs/numerics.md has the derivation.
#ifndef HALFSPACE_STUDY_PROOFS_MOTION_BOUNDS_HPP_
#define HALFSPACE_STUDY_PROOFS_MOTION_BOUNDS_HPP_

#include "hls/formats/formats.hpp"

namespace halfspace::model {

// Of the words of a triangle at a pixel: places within 2^extent pixels of the origin; `part` is S/Q, 0 … 1, the larger
// of both axes, and `q` is Q, as exact planes have them, affine Q is 2^b; `distance` is |dx| + |dy| from vertex 0, in
// pixels. The last rounding is in it.
double motion_bound(const Config& config, int extent, double part, double q, double distance);

// What the words of the vertices are off themselves: `spread` is the largest distance of a vertex from the place of the
// pixel, in units of 2^extent, `least` the least of the three q.
double motion_vertex_bound(const Config& config, int extent, double spread, double q, double least);

// Of a plane of colour differences, rounded, in units of 2^−kDifferenceFraction LSB.
double difference_bound(const Config& config, double distance);

// The bound of a vector that a table prints is of places within 2^vector_range pixels, and of a q of the upper half of
// its range.
constexpr int vector_extent(const Config& config) {
  return config.vector_range < config.range_bits ? config.vector_range : config.range_bits;
}
double vector_bound(const Config& config);

// What weights are off: of a pixel along an axis, in units of 2^−weight_bits; of a key before rounding, in LSB. 0 where
// the weights of the table are those of the formula.
constexpr double kMostRowWeights = 1449.0 / 1024;  // above √2
double tap_bound(const Config& config);
double key_colour_bound(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_MOTION_BOUNDS_HPP_
