// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_GLTF_INSTANCING_HPP_
#define HALFSPACE_REF_SCENE_GLTF_INSTANCING_HPP_

#include <optional>
#include <vector>

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {

// EXT_mesh_gpu_instancing: where the mesh of a node stands instead, as children of the node. None: the node is plain.
std::optional<std::vector<Node>> instances_of(const File&, int node);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_INSTANCING_HPP_
