// SPDX-License-Identifier: Apache-2.0
// From Assimp's materials, cameras and lights to ours.
#ifndef HALFSPACE_REF_SCENE_SCENE_FILE_PARTS_HPP_
#define HALFSPACE_REF_SCENE_SCENE_FILE_PARTS_HPP_

#include <assimp/scene.h>

#include <optional>
#include <string>
#include <vector>

#include "ref/scene/pose.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

Material material_of(const aiMaterial&);

// The colour textures of the materials, each once, from files beside the scene's or from inside it. The materials are
// those of the file, in its order.
void add_textures(const aiScene&, const std::string& path, Scene*);

// None if the camera has no direction. `extension` is the file's: importers differ in what they store.
std::optional<Camera> camera_of(const aiCamera&, const Pose&, const std::string& extension);

// Is the camera among the points, or does it have one of them in view? The importers of some formats (3DS,
// ASE) turn cameras the wrong way.
bool sees(const Camera&, const std::vector<glm::dvec3>& points);

// The lights, and the ambient light if the file has any. Files state intensities in units of their own (0-1,
// candela, lux), so all are scaled together if their sum is beyond 1/4 to 1 at the middle of scene.framing.
void add_lights(const aiScene&, const Pose&, Scene*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_SCENE_FILE_PARTS_HPP_
