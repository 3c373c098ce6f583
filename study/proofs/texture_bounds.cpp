// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/texture_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::model {

double coordinate_plane_bound(const Config& config, double distance) {
  // The start of a plane loses what lies below 2^−g.
  return std::ldexp(1.0, config.coordinate_bits - config.reciprocal_bits) +
         std::ldexp(distance / 2 + 1, -config.coordinate_fraction);
}

double texture_place_bound(const Config& config, double span, double part, double q, double distance) {
  const double rounded = 0.5 + coordinate_plane_bound(config, distance);
  if (!has_perspective(config)) return span * std::ldexp(rounded, -config.coordinate_bits);
  const double division = rounded * (1 + part) / std::max(q - rounded, 1.0);
  return span * (division + (part + division) * kInverseError);
}

double texture_vertex_bound(const Config& config, double span, double spread, double q, double least) {
  // Affine: 2^b is taken as 2^b − 1.
  if (!has_perspective(config)) return span * std::ldexp(1.0, -config.coordinate_bits);
  const double quantized = least > 1 ? 0.5 : 1;
  return span * (quantized * spread + 0.5) / q;
}

double texture_cut_bound(const Config& config) { return is_bilinear(config) ? std::ldexp(1.0, -kWeightBits - 1) : 0; }

}  // namespace halfspace::model
