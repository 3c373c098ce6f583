// SPDX-License-Identifier: Apache-2.0
// Assimp brings a library along, Draco, that has another version of tinygltf in it, with functions of the same names: a
// program that is linked with both runs either's. So ours has a namespace of its own, and is compiled with us
// (tinygltf.cpp) without its pictures, for which ours stand.
#ifndef HALFSPACE_REF_SCENE_GLTF_FILE_TINYGLTF_HPP_
#define HALFSPACE_REF_SCENE_GLTF_FILE_TINYGLTF_HPP_

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON
#define tinygltf halfspace_tinygltf
#include <tiny_gltf.h>
#undef tinygltf

namespace halfspace::ref::gltf {
namespace tinygltf = ::halfspace_tinygltf;
}

#endif  // HALFSPACE_REF_SCENE_GLTF_FILE_TINYGLTF_HPP_
