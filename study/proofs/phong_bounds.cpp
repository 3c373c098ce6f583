// SPDX-License-Identifier: Apache-2.0
#include "study/proofs/phong_bounds.hpp"

#include <algorithm>
#include <cmath>

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

namespace {

double word_error(const Config& config, double distance) {
  return std::sqrt(3.0) * (0.5 + normal_plane_bound(config, distance));
}
double chord_of(double error, double length) {
  return length > error ? std::min(2.0, error / (length - error / 2)) : 2;
}

}  // namespace

PhongBound phong_bound(const LightingFrame& frame, int material, const RealNormal& n, int channel, double distance,
                       const Config& config) {
  const double x = double(n[0]), y = double(n[1]), z = double(n[2]), length = std::sqrt(x * x + y * y + z * z);
  const double chord = chord_of(word_error(config, distance), length), turn = 2 * std::asin(chord / 2);
  const double unit = std::ldexp(1.0, cosine_fraction(config) + 1), lsb = std::ldexp(1.0, -kCoefficientFraction);
  const RawMaterial& surface = frame.materials[std::size_t(material)];
  const int squarings = std::min(surface.gloss, exact_log2(config.gloss));
  const double power = std::ldexp(1.0, squarings);
  PhongBound bound{0, 0};
  for (std::size_t i = 0; i < frame.lights.size(); ++i) {
    const auto& way = frame.lights[i].to_light;
    const auto& half = frame.lights[i].half;
    const double long_light = std::hypot(double(way[0]), double(way[1]), double(way[2])) / unit;
    const double long_half = std::hypot(double(half[0]), double(half[1]), double(half[2])) / unit;
    const double along = length > 0 ? (x * way[0] + y * way[1] + z * way[2]) / (length * unit) : 0;
    const double towards = length > 0 ? (x * half[0] + y * half[1] + z * half[2]) / (length * unit) : 0;
    const double off = chord * long_light;
    if (along <= -off) continue;
    const double diffuse = lsb * surface.reflections[i].diffuse[channel];
    const double specular = has_gloss(config) ? lsb * surface.reflections[i].specular[channel] : 0;
    bound.error += diffuse * (std::min(off, 1.0) + value(cosine_bound(config)));
    if (specular == 0) continue;
    const double slope = power_slope(squarings) * std::pow(std::max(long_half, 1.0), power) * turn;
    bound.error += specular * (std::min(slope, 1.0) + value(power_bound(config, squarings)));
    const double most = std::clamp(towards + chord * long_half, 0.0, 1.0);
    if (std::fabs(along) <= off) bound.jump += specular * std::pow(most, power);
  }
  return bound;
}

WhitePhong white_phong(const Config& config) {
  const double plane = word_error(config, value(largest_reach(config, Vertices::kGuardBand)));
  WhitePhong out{dyadic_above(std::ldexp(plane, -config.normal_bits)), {0, 0}, {0, 0}, {0, 0}, {0, 0}};
  out.chord = dyadic_above(chord_of(value(out.error), 0.5));
  out.cosine = dyadic_above(value(out.chord) * longest_direction(config));
  Dyadic sum = out.cosine + cosine_bound(config);
  if (has_gloss(config)) {
    const int squarings = exact_log2(config.gloss);
    const double turn = 2 * std::asin(value(out.chord) / 2);
    out.power = dyadic_above(power_slope(squarings) * std::pow(longest_direction(config), config.gloss) * turn);
    sum = sum + out.power + power_bound(config, squarings);
  }
  out.rounded = ((1 << config.colour_bits) - 1) * sum + Dyadic{1, -1};
  return out;
}

}  // namespace halfspace::model
