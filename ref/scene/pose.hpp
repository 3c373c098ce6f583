// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_POSE_HPP_
#define HALFSPACE_REF_SCENE_POSE_HPP_

#include <assimp/scene.h>

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

glm::dmat4 to_glm(const aiMatrix4x4&);
inline glm::dvec3 to_glm(const aiVector3D& v) { return {v.x, v.y, v.z}; }
inline glm::dvec3 to_glm(const aiColor3D& c) { return {c.r, c.g, c.b}; }

// Where every node of a file stands at a time, and how far its meshes have morphed, as the first animation has it; held
// at its ends outside its duration. Assimp joins nodes, bones, cameras and lights by name.
class Pose {
 public:
  Pose(const aiScene&, double time_seconds);

  // Of the first animation, seconds; 0 without one.
  double duration() const { return duration_; }
  // Identity for a name that no node has.
  glm::dmat4 to_world(const std::string& node) const;
  const glm::dmat4& to_world(const aiNode* node) const { return by_node_.at(node); }
  // Of the morph targets of a mesh at a node, one each.
  std::vector<double> morph_weights(const aiNode&, const aiMesh&) const;

 private:
  void place(const aiNode&, const glm::dmat4& parent);

  double duration_ = 0;
  std::map<std::string, glm::dmat4> animated_;  // to the parent
  std::map<std::string, glm::dmat4> by_name_;
  std::map<const aiNode*, glm::dmat4> by_node_;
  std::map<std::string, std::map<unsigned, double>> morphs_;  // a weight a target, of a node or a mesh
};

// Moves the vertices and normals of a mesh to its morph targets, weighted.
void morph(const aiMesh&, const std::vector<double>& weights, Mesh* mesh);

// Moves the vertices and normals of a mesh by its bones, into the world.
void skin(const aiMesh&, const Pose&, const glm::dmat4& of_node, Mesh* mesh);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_POSE_HPP_
