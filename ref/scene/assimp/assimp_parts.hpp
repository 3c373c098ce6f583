// SPDX-License-Identifier: Apache-2.0
// From what Assimp makes of a file to a document. Assimp joins nodes, bones, channels, cameras and lights by name: the
// first node of a name counts.
#ifndef HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_PARTS_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_PARTS_HPP_

#include <assimp/scene.h>

#include <map>
#include <string>
#include <vector>

#include "ref/scene/assimp/assimp_materials.hpp"
#include "ref/scene/assimp/collada.hpp"
#include "ref/scene/document.hpp"

namespace halfspace::ref {

glm::dmat4 to_glm(const aiMatrix4x4&);
inline glm::dvec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }
inline glm::dvec3 to_glm(const aiColor3D& c) { return {c.r, c.g, c.b}; }
// Black where it is NaN or infinite, and not below 0.
glm::dvec3 sane_colour(const glm::dvec3&);
bool is_black(const glm::dvec3&);

using NodeNumbers = std::map<std::string, int>;

// The nodes of the document.
NodeNumbers add_nodes(const aiScene&, Document*);
// Meshes, and their skins. `places`: of the textures of the materials.
void add_meshes(const aiScene&, const NodeNumbers&, const std::vector<TexturePlace>& places, const ReadChoice&,
                Document*);
// By how much of a mesh's size its coordinates are rounded. More than kCoarse is seen.
double coarseness(const aiMesh&);
constexpr double kCoarse = 1.0 / 4096;
void add_animations(const aiScene&, const NodeNumbers&, Document*);
// `collada`: what its cameras are, where the file is of that format.
void add_cameras(const aiScene&, const NodeNumbers&, const Collada& collada, Document*);
void add_lights(const aiScene&, const NodeNumbers&, Document*);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_ASSIMP_PARTS_HPP_
