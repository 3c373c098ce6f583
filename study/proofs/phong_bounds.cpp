// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/phong_bounds.hpp"

#include <algorithm>
#include <cmath>

#include "study/proofs/lighting_bounds.hpp"

namespace halfspace::model {

double normal_plane_bound(const Config& config, double distance) {
  // The start of a plane loses what lies below 2^−g.
  return std::ldexp(1.0, normal_plane_bits(config) - config.reciprocal_bits) +
         std::ldexp(distance / 2 + 1, -config.normal_fraction);
}

double normal_bound(const Config& config, double distance) {
  // A component of 1 is a unit off as it is quantized, and half a unit the two others, which are next to 0.
  const double vertices = std::sqrt(1.5), plane = std::sqrt(3.0) * (0.5 + normal_plane_bound(config, distance));
  return std::ldexp(vertices + plane, -config.normal_bits);
}

double power_slope(int squarings) {
  const double m = std::ldexp(1.0, squarings);
  return std::sqrt(m) * std::pow((m - 1) / m, (m - 1) / 2);
}

PhongBound phong_bound(const ref::DistantScene& scene, int material, const glm::dvec3& n, int channel, double distance,
                       const Config& config) {
  const double length = glm::length(n), error = normal_bound(config, distance);
  // A turn of the normal: any, where it is no longer than its error.
  const double chord = length > error ? std::min(2.0, error / (length - error / 2)) : 2.0;
  const double turn = 2 * std::asin(chord / 2);
  const double direction = std::ldexp(std::sqrt(1.5), -cosine_fraction(config) - 1);
  const double coefficient = std::ldexp(0.5, -kCoefficientFraction);
  const ref::DistantMaterial& surface = scene.materials[std::size_t(material)];
  const double scale = ((1 << config.colour_bits) - 1) / 255.0, power = std::ldexp(1.0, surface.squarings);
  PhongBound bound{coefficient, 0};
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const double along = glm::dot(n, scene.lights[i].to_light) / length, off = chord + direction;
    const double diffuse = scale * surface.reflections[i].diffuse[channel];
    const double specular = scale * surface.reflections[i].specular[channel];
    if (along <= -off) continue;
    bound.error += coefficient + diffuse * (off + value(cosine_bound(config)));
    if (!has_gloss(config) || specular == 0) continue;
    const double slope = power_slope(surface.squarings) * turn + power * direction;
    bound.error += coefficient + specular * (std::min(slope, 1.0) + value(power_bound(config, surface.squarings)));
    const double cosine = std::max(glm::dot(n, scene.lights[i].half) / length, 0.0);
    if (std::fabs(along) < off) bound.jump += specular * std::pow(std::min(cosine + off, 1.0), power);
  }
  return bound;
}

}  // namespace halfspace::model
