// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_VIEWPOINT_HPP_
#define HALFSPACE_REF_VIEWPOINT_HPP_

#include <glm/glm.hpp>

#include "ref/scene.hpp"

namespace halfspace::ref {

// From where and how a frame is seen.
struct Viewpoint {
  glm::dvec3 eye, forward, right, up;  // in the world; right-handed, each of length 1
  bool orthographic;                   // then seen along `forward` from everywhere
  glm::dmat4 to_clip;                  // world to clip space, 0 <= z <= w

  glm::dvec3 to_viewer(const glm::dvec3& point) const {
    return orthographic ? -forward : glm::normalize(eye - point);
  }
};

// The scene's camera, or one that frames the scene; `aspect` is width / height of the frame.
Viewpoint viewpoint(const Scene&, double aspect);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_VIEWPOINT_HPP_
