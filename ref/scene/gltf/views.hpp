// SPDX-License-Identifier: Apache-2.0
// What a scene is seen by: cameras and lights.
#ifndef HALFSPACE_REF_SCENE_GLTF_VIEWS_HPP_
#define HALFSPACE_REF_SCENE_GLTF_VIEWS_HPP_

#include "ref/scene/gltf/file/file.hpp"

namespace halfspace::ref::gltf {

DocumentCamera camera_of(const File&, int camera);

// Light of no strength: none.
std::optional<Light> light_of(const File&, int light);

// Of a node of the file; −1: it has none.
int light_number(const File&, int node);

}  // namespace halfspace::ref::gltf

#endif  // HALFSPACE_REF_SCENE_GLTF_VIEWS_HPP_
