// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/lighting_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::model {

Dyadic cosine_bound(const Config& config) { return kRootBound + Dyadic{1, -cosine_fraction(config)}; }

Dyadic power_bound(const Config& config, int squarings) {
  Dyadic bound = cosine_bound(config);
  for (int j = 0; j < squarings; ++j)
    bound = Dyadic{bound.mantissa, bound.exponent + 1} + Dyadic{1, -cosine_fraction(config) - 1};
  return bound;
}

Dyadic light_bound(const Config& config) {
  Dyadic bound = cosine_bound(config);
  if (has_gloss(config)) bound = bound + power_bound(config, exact_log2(config.gloss));
  return {((1 << config.colour_bits) - 1) * bound.mantissa, bound.exponent};
}

ExactLight exact_light(const LightingFrame& frame, int material, const RealNormal& normal, int channel,
                       const Config& config) {
  using Real = long double;
  const RawMaterial& surface = frame.materials[std::size_t(material)];
  const Real unit = std::ldexp(Real(1), cosine_fraction(config) + 1), lsb = std::ldexp(Real(1), -kCoefficientFraction);
  auto dot = [&](const std::array<int, 3>& way) {
    return normal[0] * Real(way[0]) + normal[1] * Real(way[1]) + normal[2] * Real(way[2]);
  };
  const Real length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  auto cosine = [&](Real along) { return std::clamp(along / (length * unit), Real(0), Real(1)); };
  const int squarings = std::min(surface.gloss, exact_log2(config.gloss));
  ExactLight result{0, 0};
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const RawReflection& reflection = surface.reflections[i];
    result.value += lsb * reflection.base[channel];
    const Real along = dot(frame.lights[i].to_light);
    if (!(along > 0)) continue;
    result.value += lsb * reflection.diffuse[channel] * cosine(along);
    result.bound += lsb * reflection.diffuse[channel] * Real(value(cosine_bound(config)));
    const Real half = dot(frame.lights[i].half);
    if (!has_gloss(config) || !(half > 0)) continue;
    result.value += lsb * reflection.specular[channel] * std::pow(cosine(half), Real(1 << squarings));
    result.bound += lsb * reflection.specular[channel] * Real(value(power_bound(config, squarings)));
  }
  return result;
}

}  // namespace halfspace::model
