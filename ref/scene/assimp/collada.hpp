// SPDX-License-Identifier: Apache-2.0
// What Assimp's importer of Collada leaves out or does not survive, read beside it.
#ifndef HALFSPACE_REF_SCENE_ASSIMP_COLLADA_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_COLLADA_HPP_

#include <map>
#include <string>
#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

struct Collada {
  // Size and planes of the cameras at each node, by the name that Assimp gives to the node; "" for all nodes that have
  // neither id nor sid.
  std::map<std::string, std::vector<Camera>> cameras;
};

// Of a file of that ending; nothing of another, or of one that is no XML. Error with the path on a list of indices with
// a word that is none: Assimp waits for ever at it.
Collada read_collada(const std::string& path);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_COLLADA_HPP_
