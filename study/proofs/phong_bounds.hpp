// SPDX-License-Identifier: Apache-2.0
// How far off the colour of a Phong-shaded pixel may be. docs/numerics.md has the derivation.
#ifndef HALFSPACE_STUDY_PROOFS_PHONG_BOUNDS_HPP_
#define HALFSPACE_STUDY_PROOFS_PHONG_BOUNDS_HPP_

#include "model/shade/lighting.hpp"
#include "ref/geometry/distant_lighting.hpp"
#include "study/proofs/lighting_bounds.hpp"

namespace halfspace::model {

// Of a component of an interpolated normal, in units of 2^−p, before rounding, from the normals of the vertices as
// quantized: `distance` is |dx| + |dy| from vertex 0, in pixels.
double normal_plane_bound(const Config& config, double distance);
// The length of the error of an interpolated normal, the quantization of the vertices' and the rounding included.
double normal_bound(const Config& config, double distance);
// The largest slope of cos^m, m = 2^squarings, a radian.
double power_slope(int squarings);

// Of a channel before its last rounding, in LSB, against distant_colour() of the exact interpolated normal `n`, which
// is not 0.
struct PhongBound {
  double error;
  double jump;  // of the highlights of lights that graze: the model switches them on where N·L passes 0
};
PhongBound phong_bound(const ref::DistantScene& scene, int material, const glm::dvec3& n, int channel, double distance,
                       const Config& config);

// The same from the words of a triangle: of a channel before rounding, against exact_light() of the exact plane of its
// normals, `n` in units of 2^−p. The registers of lights are what they are.
PhongBound phong_bound(const LightingFrame& frame, int material, const RealNormal& n, int channel, double distance,
                       const Config& config);

// The bound that a table prints is of one light that is white at full scale, with the largest exponent that is built,
// of a normal that is ½ long at least, and where no light grazes.
// A register of a unit vector is longer than 1 by no more.
constexpr double longest_direction(const Config& config) {
  return 1 + 1.0 / double(std::int64_t(1) << cosine_fraction(config));
}
// As dyadic numbers, for a script.
struct WhitePhong {
  Dyadic error;          // of the plane of a normal, in length
  Dyadic chord;          // Δ
  Dyadic cosine, power;  // what a cosine, and its largest power, are off for that
  Dyadic rounded;        // of the colour
};
WhitePhong white_phong(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_PHONG_BOUNDS_HPP_
