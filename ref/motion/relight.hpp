// SPDX-License-Identifier: Apache-2.0
// What the light changes on a surface from a key frame to the frame between.
#ifndef HALFSPACE_REF_MOTION_RELIGHT_HPP_
#define HALFSPACE_REF_MOTION_RELIGHT_HPP_

#include "ref/geometry/geometry.hpp"
#include "ref/motion/compensate.hpp"

namespace halfspace::ref {

// Of the vertices of each triangle of a frame: their lit colours there less those of the same points at a key, 0-255,
// as rounded to the colour bits at either, so that the planes of the difference are the difference of the planes. Where
// a texture multiplies what is lit, times its mean: which texel a key shows is not known.
using LightChange = std::vector<std::array<glm::dvec3, 3>>;
LightChange light_change(Geometry& between, Geometry& key, int colour_bits, bool textured);

// By planes, at each pixel of the field. `between` is the frame's of exact motion.
LightPlanes light_planes(const Between& between, const MotionField&, const RasterFormat&, const OfKeys<LightChange>&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_RELIGHT_HPP_
