// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/pose.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace halfspace::ref {
namespace {

constexpr double kDefaultTicks = 25;  // a second, of a file that does not say

glm::dvec3 between(const aiVectorKey& a, const aiVectorKey& b, double t) {
  return glm::mix(to_glm(a.mValue), to_glm(b.mValue), t);
}
glm::dquat between(const aiQuatKey& a, const aiQuatKey& b, double t) {
  const auto quaternion = [](const aiQuaternion& q) { return glm::dquat(q.w, q.x, q.y, q.z); };
  return glm::normalize(glm::slerp(quaternion(a.mValue), quaternion(b.mValue), t));
}

std::map<unsigned, double> between(const aiMeshMorphKey& a, const aiMeshMorphKey& b, double t) {
  std::map<unsigned, double> weights;
  for (unsigned i = 0; i < a.mNumValuesAndWeights; ++i) weights[a.mValues[i]] += (1 - t) * a.mWeights[i];
  for (unsigned i = 0; i < b.mNumValuesAndWeights; ++i) weights[b.mValues[i]] += t * b.mWeights[i];
  return weights;
}

template <class Key>
auto at_time(const Key* keys, unsigned count, double ticks) {
  const Key* next = std::upper_bound(keys, keys + count, ticks, [](double t, const Key& key) { return t < key.mTime; });
  if (next == keys) return between(*next, *next, 0);
  const Key* last = next - 1;
  if (next == keys + count || next->mTime <= last->mTime) return between(*last, *last, 0);
  return between(*last, *next, (ticks - last->mTime) / (next->mTime - last->mTime));
}

glm::dmat4 at_time(const aiNodeAnim& channel, double ticks) {
  glm::dmat4 matrix(1);
  if (channel.mNumPositionKeys) {
    matrix = glm::translate(matrix, at_time(channel.mPositionKeys, channel.mNumPositionKeys, ticks));
  }
  if (channel.mNumRotationKeys) {
    matrix *= glm::mat4_cast(at_time(channel.mRotationKeys, channel.mNumRotationKeys, ticks));
  }
  if (channel.mNumScalingKeys) {
    matrix = glm::scale(matrix, at_time(channel.mScalingKeys, channel.mNumScalingKeys, ticks));
  }
  return matrix;
}

}  // namespace

// Assimp stores rows, GLM columns.
glm::dmat4 to_glm(const aiMatrix4x4& m) {
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = m[row][column];
  }
  return matrix;
}

Pose::Pose(const aiScene& scene, double time_seconds) {
  if (scene.mNumAnimations > 0) {
    const aiAnimation& animation = *scene.mAnimations[0];
    const double ticks_a_second = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : kDefaultTicks;
    const double ticks = time_seconds * ticks_a_second;
    duration_ = animation.mDuration / ticks_a_second;
    for (unsigned i = 0; i < animation.mNumChannels; ++i) {
      animated_[animation.mChannels[i]->mNodeName.C_Str()] = at_time(*animation.mChannels[i], ticks);
    }
    for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i) {
      const aiMeshMorphAnim& channel = *animation.mMorphMeshChannels[i];
      if (channel.mNumKeys) morphs_[channel.mName.C_Str()] = at_time(channel.mKeys, channel.mNumKeys, ticks);
    }
  }
  if (scene.mRootNode) place(*scene.mRootNode, glm::dmat4(1));
}

void Pose::place(const aiNode& node, const glm::dmat4& parent) {
  const auto animated = animated_.find(node.mName.C_Str());
  const glm::dmat4 here = parent * (animated == animated_.end() ? to_glm(node.mTransformation) : animated->second);
  by_node_[&node] = here;
  by_name_.emplace(node.mName.C_Str(), here);
  for (unsigned i = 0; i < node.mNumChildren; ++i) place(*node.mChildren[i], here);
}

glm::dmat4 Pose::to_world(const std::string& node) const {
  const auto found = by_name_.find(node);
  return found == by_name_.end() ? glm::dmat4(1) : found->second;
}

// Importers name a channel after the node or after the mesh.
std::vector<double> Pose::morph_weights(const aiNode& node, const aiMesh& mesh) const {
  std::vector<double> weights;
  for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i) weights.push_back(mesh.mAnimMeshes[i]->mWeight);
  auto found = morphs_.find(node.mName.C_Str());
  if (found == morphs_.end()) found = morphs_.find(mesh.mName.C_Str());
  if (found == morphs_.end()) return weights;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const auto weight = found->second.find(unsigned(i));
    weights[i] = weight == found->second.end() ? 0 : weight->second;
  }
  return weights;
}

// v + Σ w·(t − v), or of relative targets v + Σ w·t.
void morph(const aiMesh& source, const std::vector<double>& weights, Mesh* mesh) {
  const double less = source.mMethod == aiMorphingMethod_MORPH_RELATIVE ? 0 : 1;
  const auto blend = [&](std::vector<glm::dvec3>& values, aiVector3D* aiAnimMesh::*target) {
    const std::vector<glm::dvec3> base = values;
    for (unsigned i = 0; i < source.mNumAnimMeshes; ++i) {
      const aiAnimMesh& anim = *source.mAnimMeshes[i];
      if (!(anim.*target) || anim.mNumVertices != base.size()) continue;
      for (std::size_t v = 0; v < base.size(); ++v)
        values[v] += weights[i] * (to_glm((anim.*target)[v]) - less * base[v]);
    }
  };
  blend(mesh->positions, &aiAnimMesh::mVertices);
  blend(mesh->normals, &aiAnimMesh::mNormals);
  for (glm::dvec3& normal : mesh->normals) {
    const double length = glm::length(normal);
    if (length > 0) normal /= length;
  }
}

// Linear blend skinning: a vertex is moved by the weighted mean of its bones' matrices, each from the mesh as
// it was bound.
void skin(const aiMesh& source, const Pose& pose, const glm::dmat4& of_node, Mesh* mesh) {
  std::vector<glm::dmat4> blend(mesh->positions.size(), glm::dmat4(0));
  std::vector<double> weights(mesh->positions.size(), 0);
  for (unsigned i = 0; i < source.mNumBones; ++i) {
    const aiBone& bone = *source.mBones[i];
    const glm::dmat4 matrix = pose.to_world(bone.mName.C_Str()) * to_glm(bone.mOffsetMatrix);
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      const aiVertexWeight& weight = bone.mWeights[w];
      if (weight.mVertexId >= blend.size()) continue;
      blend[weight.mVertexId] += double(weight.mWeight) * matrix;
      weights[weight.mVertexId] += weight.mWeight;
    }
  }
  for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
    const glm::dmat4 matrix = weights[v] > 1e-6 ? blend[v] / weights[v] : of_node;
    mesh->positions[v] = matrix * glm::dvec4(mesh->positions[v], 1);
    const glm::dvec3 normal = glm::dmat3(matrix) * mesh->normals[v];
    const double length = glm::length(normal);
    if (length > 0) mesh->normals[v] = normal / length;
  }
}

}  // namespace halfspace::ref
