// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_EXTENSIONS_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_EXTENSIONS_HPP_

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {

// Error on one that is required and not drawn; a remark on those that are used, not drawn, and change the picture.
void check_extensions(File* file);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_EXTENSIONS_HPP_
