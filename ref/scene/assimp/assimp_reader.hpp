// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_READER_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_READER_HPP_

#include <string>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// A file of a format that Assimp reads. Points and lines are left out, and textures too unless they are asked for:
// their materials show the diffuse colour. Error with the path.
Document read_by_assimp(const std::string& path, const ReadChoice&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_READER_HPP_
