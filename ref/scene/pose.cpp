// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/pose.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "ref/scene/normals.hpp"

namespace halfspace::ref {
namespace {

using Values = std::vector<double>;

glm::dquat rotation_of(const Values& v) { return glm::dquat(v[3], v[0], v[1], v[2]); }
glm::dvec3 vector_of(const Values& v) { return {v[0], v[1], v[2]}; }

// A line between two values, of rotations the shortest way round.
Values between(ChannelPath path, const Values& a, const Values& b, double t) {
  if (path == ChannelPath::kRotation) {
    const glm::dquat q = glm::normalize(glm::slerp(rotation_of(a), rotation_of(b), t));
    return {q.x, q.y, q.z, q.w};
  }
  Values mixed(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) mixed[i] = a[i] * (1 - t) + b[i] * t;
  return mixed;
}

// The cubic Hermite spline; tangents are a second's.
Values hermite(const Values& a, const Values& leave, const Values& arrive, const Values& b, double t, double seconds) {
  const double t2 = t * t, t3 = t2 * t;
  Values mixed(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    mixed[i] = (2 * t3 - 3 * t2 + 1) * a[i] + seconds * (t3 - 2 * t2 + t) * leave[i] + (-2 * t3 + 3 * t2) * b[i] +
               seconds * (t3 - t2) * arrive[i];
  }
  return mixed;
}

Values at_time(const Channel& channel, double seconds) {
  const bool cubic = channel.interpolation == Interpolation::kCubic;
  const std::size_t keys = channel.times.size(), parts = cubic ? 3 : 1, width = channel.values.size() / (keys * parts);
  const auto part = [&](std::size_t key, std::size_t which) {
    const auto start = channel.values.begin() + std::ptrdiff_t((key * parts + which) * width);
    return Values(start, start + std::ptrdiff_t(width));
  };
  const auto value = [&](std::size_t key) { return part(key, cubic ? 1 : 0); };
  const std::size_t next =
      std::upper_bound(channel.times.begin(), channel.times.end(), seconds) - channel.times.begin();
  if (next == 0) return value(0);
  const std::size_t last = next - 1;
  if (next == keys || channel.interpolation == Interpolation::kStep) return value(last);
  const double length = channel.times[next] - channel.times[last];
  const double t = (seconds - channel.times[last]) / length;
  if (cubic) return hermite(value(last), part(last, 2), part(next, 0), value(next), t, length);
  return between(channel.path, value(last), value(next), t);
}

glm::dmat4 matrix_of(const Node& node) {
  return glm::scale(glm::translate(glm::dmat4(1), node.translation) * glm::mat4_cast(node.rotation), node.scale);
}

void set(ChannelPath path, const Values& value, Node* node) {
  switch (path) {
    case ChannelPath::kTranslation: node->translation = vector_of(value); break;
    case ChannelPath::kRotation: node->rotation = glm::normalize(rotation_of(value)); break;
    case ChannelPath::kScale: node->scale = vector_of(value); break;
    case ChannelPath::kWeights: node->weights = value;
  }
}

void normalize(glm::dvec3* normal) {
  const double length = glm::length(*normal);
  if (length > 0) *normal /= length;
}

}  // namespace

Pose::Pose(const Document& document, const Animation* animation, double seconds) {
  std::vector<Node> nodes = document.nodes;
  if (animation) {
    for (const Channel& channel : animation->channels) {
      Node& node = nodes[channel.node];
      set(channel.path, at_time(channel, seconds), &node);
    }
    for (const Channel& channel : animation->channels) {
      if (channel.path != ChannelPath::kWeights) nodes[channel.node].matrix = matrix_of(nodes[channel.node]);
    }
  }
  for (Node& node : nodes) {
    to_world_.push_back(to_world(node.parent) * node.matrix);
    weights_.push_back(std::move(node.weights));
  }
}

std::vector<double> Pose::weights(int node, const DocumentMesh& mesh) const {
  if (weights_[node].size() == mesh.targets.size()) return weights_[node];
  std::vector<double> weights;
  for (const MorphTarget& target : mesh.targets) weights.push_back(target.weight);
  return weights;
}

void morph(const DocumentMesh& source, const std::vector<double>& weights, Mesh* mesh) {
  for (std::size_t i = 0; i < source.targets.size(); ++i) {
    const MorphTarget& target = source.targets[i];
    for (std::size_t v = 0; v < target.positions.size(); ++v) mesh->positions[v] += weights[i] * target.positions[v];
    for (std::size_t v = 0; v < target.normals.size(); ++v) mesh->normals[v] += weights[i] * target.normals[v];
  }
  for (glm::dvec3& normal : mesh->normals) normalize(&normal);
}

void skin(const DocumentMesh& source, const Skin& joints, const Pose& pose, const glm::dmat4& of_node, Mesh* mesh) {
  std::vector<glm::dmat4> matrices;
  for (const Joint& joint : joints) matrices.push_back(pose.to_world(joint.node) * joint.from_mesh);
  std::vector<glm::dmat4> blend(mesh->positions.size(), glm::dmat4(0));
  std::vector<double> sums(mesh->positions.size(), 0);
  for (const JointWeight& weight : source.joint_weights) {
    blend[weight.vertex] += weight.weight * matrices[weight.joint];
    sums[weight.vertex] += weight.weight;
  }
  std::vector<bool> mirrored(mesh->positions.size());
  for (std::size_t v = 0; v < mesh->positions.size(); ++v) {
    const glm::dmat4 matrix = sums[v] > 1e-6 ? blend[v] / sums[v] : of_node;
    mirrored[v] = glm::determinant(glm::dmat3(matrix)) < 0;
    mesh->positions[v] = matrix * glm::dvec4(mesh->positions[v], 1);
    mesh->normals[v] = normal_matrix(matrix) * mesh->normals[v];
    normalize(&mesh->normals[v]);
  }
  for (auto& corner : mesh->triangles) {
    if (mirrored[corner[0]] && mirrored[corner[1]] && mirrored[corner[2]]) std::swap(corner[1], corner[2]);
  }
}

}  // namespace halfspace::ref
