// SPDX-License-Identifier: Apache-2.0
// What moves: animations and skins.
#ifndef HALFSPACE_REF_SCENE_GLTF_MOTION_HPP_
#define HALFSPACE_REF_SCENE_GLTF_MOTION_HPP_

#include <vector>

#include "ref/scene/gltf/nodes.hpp"

namespace halfspace::ref::gltf {

Skin skin_of(const File&, int number, const NodeOrder&);

// `targets`: of the mesh of each node of the document.
Animation animation_of(File*, int number, const NodeOrder&, const std::vector<std::size_t>& targets);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_MOTION_HPP_
