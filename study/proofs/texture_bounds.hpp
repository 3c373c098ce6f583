// SPDX-License-Identifier: Apache-2.0
// How far off the place of a pixel in its texture may be, in texels. docs/numerics.md has the derivation.
#ifndef HALFSPACE_STUDY_PROOFS_TEXTURE_BOUNDS_HPP_
#define HALFSPACE_STUDY_PROOFS_TEXTURE_BOUNDS_HPP_

#include <cstdint>

#include "hls/formats/formats.hpp"
#include "study/proofs/bounds_proved.hpp"

namespace halfspace::model {

// ρ: of |y·m − 1| of reciprocal_lookup. texture_kernel_test tries every field.
constexpr double kInverseError = 1.0 / (1 << 18);

// Of a plane of s, t or q, in units, before rounding: `distance` is |dx| + |dy| from vertex 0, in pixels.
double coordinate_plane_bound(const Config& config, double distance);

// What the kernels add to the exact place S/Q of the words of a triangle, where 2^e repetitions are `span` texels;
// `part` is S/Q, 0 … 1, and `q` is Q: as exact planes have them. Affine: Q is 2^b. Before the place is cut to 8 bits.
double texture_place_bound(const Config& config, double span, double part, double q, double distance);

// What the words of the vertices are off themselves: `spread` is the largest distance of a vertex's u′/2^e from that of
// the pixel, `least` the least of the three q.
double texture_vertex_bound(const Config& config, double span, double spread, double q, double least);

// What cutting to 8 bits adds, to either side: 2^−9 where there are weights, none for the nearest.
double texture_cut_bound(const Config& config);

// The bound that a table prints is of a square texture that fills the memory, once across the triangle, and of a q of
// the upper half of its range: vertices of which none is more than twice as far as another.
constexpr int square_side(const Config& config) { return (exact_log2(config.texels) + 1) / 2; }  // its longer side
constexpr double least_q(const Config& config) { return double(std::int64_t(1) << (config.coordinate_bits - 1)); }
// As dyadic numbers, for a script: of s and q as rounded, with the vertex as far away as can be; of s/q where it is 1
// and q least, d of docs/numerics.md; and of the place, 2^log2_span times that. Affine there is no quotient.
struct PlaceBounds {
  Dyadic rounded, quotient, place;
};
PlaceBounds place_bounds(const Config& config, int log2_span);
double square_place_bound(const Config& config);

// Of a filtered texel, in LSB, and of its product with a colour before that is rounded.
double filtered_bound(const Config& config);
double product_bound(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_TEXTURE_BOUNDS_HPP_
