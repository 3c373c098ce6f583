// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/motion_bounds.hpp"

#include <cmath>

#include "study/proofs/bounds_proved.hpp"
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

double vector_bound(const Config& config) {
  return value(place_bounds(config, vector_extent(config)).place + Dyadic{1, -config.vector_fraction - 1});
}

double tap_bound(const Config& config) {
  switch (config.filter) {
    case KeyFilter::kNearest: return 0;
    case KeyFilter::kBilinear: return config.weight_bits < config.vector_fraction + log2_samples(config) ? 0.5 : 0;
    case KeyFilter::kBicubic: return 1.5;
    default: return 0.5;
  }
}

double key_colour_bound(const Config& config) {
  const double full = (1 << config.colour_bits) - 1, weight = std::ldexp(tap_bound(config), -config.weight_bits);
  // Absolute weights of rows add up to √2 at most, and exact rows lie within 5/4 of full scale of each other.
  const double rows = config.filter == KeyFilter::kBicubic ? kMostRowWeights + 1.25 : 2;
  return full * weight * rows;
}

}  // namespace halfspace::model
