// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_SCENE_FILE_HPP_
#define HALFSPACE_REF_SCENE_SCENE_FILE_HPP_

#include <string>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// A file that Assimp reads. Points and lines are left out, and textures too unless they are asked for: their materials
// show the diffuse colour. Indices and coordinates are still to be checked.
Scene read_scene_file(const std::string& path, double time_seconds, bool textured);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_SCENE_FILE_HPP_
