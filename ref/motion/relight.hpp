// SPDX-License-Identifier: Apache-2.0
// What the light changes on a surface from a key frame to the frame between.
#ifndef HALFSPACE_REF_MOTION_RELIGHT_HPP_
#define HALFSPACE_REF_MOTION_RELIGHT_HPP_

#include "ref/geometry/geometry.hpp"
#include "ref/motion/compensate.hpp"

namespace halfspace::ref {

// `between` is the frame, `key` the same scene at a key.
LightChange light_change(Geometry& between, Geometry& key, int colour_bits, bool textured);
// With lights at infinity, as hardware has them; `most_squarings` as distant_scene takes it.
LightChange distant_light_change(const Geometry& between, const Geometry& key, int most_squarings, int colour_bits,
                                 bool textured);

// By planes, at each pixel of the field. `between` is the frame's of exact motion.
LightPlanes light_planes(const Between& between, const MotionField&, const RasterFormat&, const OfKeys<LightChange>&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_RELIGHT_HPP_
