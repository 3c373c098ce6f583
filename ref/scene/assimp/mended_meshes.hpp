// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_MENDED_MESHES_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_MENDED_MESHES_HPP_

#include <assimp/scene.h>

#include <cstddef>
#include <string>
#include <vector>

namespace halfspace::ref {

// Faces that have no area to draw.
struct LeftOut {
  std::size_t lines = 0, points = 0, empty = 0;

  std::vector<std::string> remarks() const;
};

// Takes out of what Assimp has read, before it checks and triangulates it, faces of fewer than three corners, of which
// its importers tell wrong kinds, and then meshes without faces, and those that it makes of bones.
LeftOut mend_meshes(aiScene*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_MENDED_MESHES_HPP_
