// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/motion_bounds.hpp"

#include <cmath>

#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {

double motion_bound(const Config& config, int extent, double part, double q, double distance) {
  return texture_place_bound(config, std::ldexp(1.0, extent), part, q, distance) +
         std::ldexp(1.0, -config.vector_fraction - 1);
}

double motion_vertex_bound(const Config& config, int extent, double spread, double q, double least) {
  return texture_vertex_bound(config, std::ldexp(1.0, extent), spread, q, least);
}

double difference_bound(const Config& config, double distance) {
  // As coordinate_plane_bound, and the rounding.
  return 0.5 + std::ldexp(1.0, difference_bits(config) - config.reciprocal_bits) +
         std::ldexp(distance / 2 + 1, -config.colour_fraction);
}

}  // namespace halfspace::model
