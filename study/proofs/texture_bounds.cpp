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

PlaceBounds place_bounds(const Config& config, int log2_span) {
  const double distance = value(largest_reach(config, Vertices::kGuardBand));
  PlaceBounds out{dyadic_above(0.5 + coordinate_plane_bound(config, distance)), {0, 0}, {0, 0}};
  if (!has_perspective(config)) {
    out.place = {out.rounded.mantissa, out.rounded.exponent + log2_span - config.coordinate_bits};
    return out;
  }
  const double rounded = value(out.rounded);
  out.quotient = dyadic_above(2 * rounded / (least_q(config) - rounded));
  const double quotient = value(out.quotient);
  out.place = dyadic_above(std::ldexp(quotient + (1 + quotient) * kInverseError, log2_span));
  return out;
}

double square_place_bound(const Config& config) {
  return value(place_bounds(config, square_side(config)).place) + texture_cut_bound(config);
}

double filtered_bound(const Config& config) {
  return is_bilinear(config) ? std::ldexp(1.0, -kFilteredFraction - 1) : 0;
}

double product_bound(const Config& config) {
  const int c = config.colour_bits;
  return is_bilinear(config) ? std::ldexp(1.0, -c - 1) + std::ldexp(1.0, -c - 8) : 0;
}

}  // namespace halfspace::model
