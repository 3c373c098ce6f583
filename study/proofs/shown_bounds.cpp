// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/shown_bounds.hpp"

#include <cmath>

#include "study/proofs/lighting_bounds.hpp"
#include "study/proofs/motion_bounds.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::model {

namespace {

int full_scale(const Config& config) { return (1 << config.colour_bits) - 1; }
Dyadic operator+(const Dyadic& a, double b) { return model::operator+(a, dyadic_above(b)); }

}  // namespace

Dyadic surface_bound(const Config& config) {
  if (is_phong(config)) return white_phong(config).rounded;
  const Dyadic lit = has_lighting(config) ? light_bound(config) + 0.5 : Dyadic{0, 0};
  if (!is_gouraud(config)) return lit;
  return model::operator+(lit,
                          plane_bound(colour_numbers(config), largest_reach(config, Vertices::kGuardBand)).rounded);
}

double texel_bound(const Config& config, double u, double v, double du, double dv) {
  return filtered_bound(config) + (is_bilinear(config) ? u * du + v * dv : 0);
}

double textured_bound(const Config& config, double surface, double texel) {
  return surface + texel + product_bound(config) + 0.5;
}

double key_slope(KeyFilter filter) {
  switch (filter) {
    case KeyFilter::kBilinear: return 1;
    case KeyFilter::kArea: return 2;
    case KeyFilter::kBicubic: return 1.875;
    default: return 0;
  }
}

double between_bound(const Config& config, double vector_x, double vector_y, double difference) {
  const double full = (1 << config.colour_bits) - 1;
  return 0.5 + key_colour_bound(config) + difference +
         full * key_slope(config.filter) * (vector_x + vector_y) / config.samples;
}

ShownTexel shown_texel(const Config& config) {
  const Dyadic product = dyadic_above(product_bound(config)) + 0.5;
  if (!is_bilinear(config)) return {{0, 0}, {0, 0}, {0, 0}, {0, 0}, product};
  const Dyadic filter = dyadic_above(filtered_bound(config));
  const Dyadic place = place_bounds(config, shown_side(config)).place + texture_cut_bound(config);
  const Dyadic apart = {full_scale(config), 0};
  return {filter, place, apart, model::operator+(filter, 2 * full_scale(config) * place), product};
}

ShownKey shown_key(const Config& config) {
  const Dyadic vector = dyadic_above(vector_bound(config)), colour = dyadic_above(key_colour_bound(config)) + 0.5;
  const double reach = value(largest_reach(config, Vertices::kGuardBand));
  const double difference = relights(config) ? std::ldexp(difference_bound(config, reach), -kDifferenceFraction) : 0;
  return {colour,
          {vector.mantissa, vector.exponent - log2_samples(config)},
          dyadic_above(full_scale(config) * key_slope(config.filter)),
          dyadic_above(difference)};
}

Dyadic shown_bound(const Config& config) {
  if (has_motion(config)) {
    const ShownKey key = shown_key(config);
    const Dyadic moved = {2 * key.place.mantissa * key.slope.mantissa, key.place.exponent + key.slope.exponent};
    return dyadic_above(value(key.colour) + value(moved) + value(key.difference));
  }
  if (!has_texture(config)) return surface_bound(config);
  const ShownTexel texel = shown_texel(config);
  return dyadic_above(value(surface_bound(config)) + value(texel.texel) + value(texel.product));
}

}  // namespace halfspace::model
