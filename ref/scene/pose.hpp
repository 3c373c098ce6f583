// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_POSE_HPP_
#define HALFSPACE_REF_SCENE_POSE_HPP_

#include <glm/glm.hpp>
#include <vector>

#include "ref/scene/document.hpp"

namespace halfspace::ref {

// Where every node of a document stands at a time, and how far its meshes have morphed.
class Pose {
 public:
  // `animation` may be null: everything stands as the document has it.
  Pose(const Document&, const Animation* animation, double seconds);

  // −1: the world itself.
  const glm::dmat4& to_world(int node) const { return node < 0 ? world_ : to_world_[node]; }
  // Of the morph targets of a mesh at a node, one each.
  std::vector<double> weights(int node, const DocumentMesh&) const;

 private:
  const glm::dmat4 world_{1};
  std::vector<glm::dmat4> to_world_;
  std::vector<std::vector<double>> weights_;  // a node; none: those of the targets
};

// Moves the vertices and normals of a mesh to its targets, weighted.
void morph(const DocumentMesh&, const std::vector<double>& weights, Mesh* mesh);

// Linear blend skinning: a vertex is moved by the weighted mean of its joints' matrices into the world, one without
// weights by `of_node`; normals by the inverse transpose, and where the matrix mirrors, triangles are turned round.
void skin(const DocumentMesh&, const Skin&, const Pose&, const glm::dmat4& of_node, Mesh* mesh);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_POSE_HPP_
