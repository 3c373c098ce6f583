// SPDX-License-Identifier: Apache-2.0
// Cameras and lights of a document, placed in the world.
#ifndef HALFSPACE_REF_SCENE_PLACED_PARTS_HPP_
#define HALFSPACE_REF_SCENE_PLACED_PARTS_HPP_

#include <optional>

#include "ref/scene/pose.hpp"

namespace halfspace::ref {

// None if it has no direction.
std::optional<Camera> placed_camera(const DocumentCamera&, const Pose&);

// Is the camera among the points, or does it have one of them in view?
bool sees(const Camera&, const std::vector<glm::dvec3>& points);

// The lights, and the ambient light if there is any. Files state intensities in units of their own (0-1, candela, lux),
// so all are scaled together if their sum is beyond 1/4 to 1 at the middle of scene.framing.
void add_placed_lights(const Document&, const Pose&, Scene*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_PLACED_PARTS_HPP_
