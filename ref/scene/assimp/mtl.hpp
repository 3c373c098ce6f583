// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_MTL_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_MTL_HPP_

#include <glm/glm.hpp>
#include <map>
#include <string>

namespace halfspace::ref {

// The line of a map in a material library of an OBJ file.
struct MtlMap {
  std::string file;
  glm::dvec2 scale{1}, offset{0};  // of coordinates
  bool repeats = true;
};

struct MtlMaps {
  MtlMap diffuse, emission;  // map_Kd, map_Ke; without a file: none
};

// Adds the maps of the materials of a library, by name: Assimp passes over most options of a map, and takes the name
// for one of their numbers where there are fewer than three.
void read_mtl(const std::string& path, std::map<std::string, MtlMaps>*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_MTL_HPP_
