// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_GEOMETRY_VIEWPOINT_HPP_
#define HALFSPACE_REF_GEOMETRY_VIEWPOINT_HPP_

#include <glm/glm.hpp>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// From where and how a frame is seen.
struct Viewpoint {
  glm::dvec3 eye, forward, right, up;  // in the world; right-handed, each of length 1
  bool orthographic;                   // then seen along `forward` from everywhere
  glm::dmat4 to_clip;                  // world to clip space, 0 <= z <= w

  bool operator==(const Viewpoint& o) const {
    return eye == o.eye && forward == o.forward && right == o.right && up == o.up && orthographic == o.orthographic &&
           to_clip == o.to_clip;
  }
  bool operator!=(const Viewpoint& o) const { return !(*this == o); }

  glm::dvec3 to_viewer(const glm::dvec3& point) const { return orthographic ? -forward : glm::normalize(eye - point); }
};

// The scene's camera, or one that frames the scene; `aspect` is width / height of the frame.
Viewpoint viewpoint(const Scene&, double aspect);

// Holds the viewpoint, and has everything `zoom` times as large in the frame.
void zoom(Scene&, double zoom, double aspect);

// The depth planes of that viewpoint, and those that hold two times of an animation.
DepthPlanes depth_planes(const Scene&, double aspect);
DepthPlanes joined(const DepthPlanes&, const DepthPlanes&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_VIEWPOINT_HPP_
