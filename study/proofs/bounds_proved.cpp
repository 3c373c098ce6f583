// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/bounds_proved.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::model {

double value(const Dyadic& number) { return std::ldexp(double(number.mantissa), number.exponent); }

Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  const int exponent = std::min(a.exponent, b.exponent);
  return {(a.mantissa << (a.exponent - exponent)) + (b.mantissa << (b.exponent - exponent)), exponent};
}

Dyadic operator*(std::int64_t factor, const Dyadic& number) { return {factor * number.mantissa, number.exponent}; }

Dyadic dyadic_above(double number) {
  int exponent;
  const double mantissa = std::frexp(number, &exponent);
  return {std::int64_t(std::ceil(std::ldexp(mantissa, 24))), exponent - 24};
}

PlaneNumbers depth_numbers(const Config& config) {
  return {config.depth_bits, config.reciprocal_bits, config.depth_fraction};
}

PlaneNumbers colour_numbers(const Config& config) {
  return {config.colour_bits, config.reciprocal_bits, config.colour_fraction};
}

PlaneNumbers normal_numbers(const Config& config) {
  return {normal_plane_bits(config), config.reciprocal_bits, config.normal_fraction};
}

PlaneNumbers coordinate_numbers(const Config& config) {
  return {config.coordinate_bits, config.reciprocal_bits, config.coordinate_fraction};
}

PlaneNumbers difference_numbers(const Config& config) {
  return {difference_bits(config), config.reciprocal_bits, config.colour_fraction};
}

// A vertex at −2^(range−1) and the last centre, ½ before the far side of the frame, on both axes.
Dyadic largest_reach(const Config& config, Vertices vertices) {
  const std::int64_t beyond = vertices == Vertices::kGuardBand ? std::int64_t(1) << config.range_bits : 0;
  return {beyond + config.width + config.height - 1, 0};
}

Dyadic reciprocal_bound(const Config& config) { return {1, -config.reciprocal_bits}; }

PlaneBound plane_bound(const PlaneNumbers& n, const Dyadic& reach) {
  const Dyadic common_factor = {(std::int64_t(1) << n.value_bits) - 1, -n.reciprocal_bits};
  const Dyadic gradients = {reach.mantissa, reach.exponent - n.fraction - 1};
  const Dyadic sum = common_factor + gradients;
  return {sum, sum + Dyadic{1, -n.fraction}, sum + Dyadic{1, -1}};
}

}  // namespace halfspace::model
