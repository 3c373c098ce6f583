// SPDX-License-Identifier: Apache-2.0
// How far off the colour of a Phong-shaded pixel may be. docs/numerics.md has the derivation.
#ifndef HALFSPACE_STUDY_PROOFS_PHONG_BOUNDS_HPP_
#define HALFSPACE_STUDY_PROOFS_PHONG_BOUNDS_HPP_

#include "model/shade/lighting.hpp"
#include "ref/geometry/distant_lighting.hpp"

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

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_PHONG_BOUNDS_HPP_
