// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_MATERIALS_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_MATERIALS_HPP_

#include <assimp/scene.h>

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "ref/scene/assimp/mtl.hpp"
#include "ref/scene/document.hpp"

namespace halfspace::ref {

// How the texture of a material lies on a mesh.
struct TexturePlace {
  unsigned coordinates = 0;  // which of the mesh's sets
  glm::dmat3 placed{1};      // from the mesh's coordinates
  bool repeats = true;
};

// The materials of the document, with their textures if they are asked for, and what is said of those that are used.
// One for each material comes back. `mtl`: the maps of the material libraries of an OBJ file, by the material's name.
std::vector<TexturePlace> add_materials(const aiScene&, const std::map<std::string, MtlMaps>& mtl, const ReadChoice&,
                                        Document*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_MATERIALS_HPP_
