// SPDX-License-Identifier: Apache-2.0
// From what Assimp makes of a file to a document. Assimp joins nodes, bones, channels, cameras and lights by name: the
// first node of a name counts.
#ifndef HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_PARTS_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_PARTS_HPP_

#include <assimp/scene.h>

#include <map>
#include <string>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

glm::dmat4 to_glm(const aiMatrix4x4&);
inline glm::dvec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }
inline glm::dvec3 to_glm(const aiColor3D& c) { return {c.r, c.g, c.b}; }

using NodeNumbers = std::map<std::string, int>;

// The nodes of the document.
NodeNumbers add_nodes(const aiScene&, Document*);
// Meshes, and their skins.
void add_meshes(const aiScene&, const NodeNumbers&, Document*);
void add_animations(const aiScene&, const NodeNumbers&, Document*);
void add_cameras(const aiScene&, const NodeNumbers&, Document*);
void add_lights(const aiScene&, const NodeNumbers&, Document*);
void add_materials(const aiScene&, Document*);
// The colour textures of the materials, each once, from files beside the scene's or from inside it.
void add_textures(const aiScene&, Document*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_PARTS_HPP_
