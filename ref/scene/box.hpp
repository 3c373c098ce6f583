// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_BOX_HPP_
#define HALFSPACE_REF_SCENE_BOX_HPP_

#include <glm/glm.hpp>
#include <vector>

namespace halfspace::ref {

struct Box {
  glm::dvec3 low, high;
};

// Of one point at least.
inline Box box_of(const std::vector<glm::dvec3>& points) {
  Box box{points.front(), points.front()};
  for (const glm::dvec3& p : points) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_BOX_HPP_
