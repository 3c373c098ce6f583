// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_SHIFTED_OBJ_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_SHIFTED_OBJ_HPP_

#include <glm/glm.hpp>
#include <string>

namespace halfspace::ref {

// An OBJ file of which all vertices are given from the middle of them, `origin`: of survey coordinates float32 has
// steps of half a metre. As it was, from 0, where a vertex is not of three coordinates.
struct ShiftedObj {
  std::string text;
  glm::dvec3 origin{0};
};
ShiftedObj shifted_obj(const std::string& text);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_SHIFTED_OBJ_HPP_
