// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace halfspace::ref::gltf {
namespace {

constexpr std::size_t kMostNodes = std::size_t(1) << 20;
constexpr int kDeepest = 1000;

std::vector<int> parents_of(const File& file) {
  const std::vector<tinygltf::Node>& nodes = file.model.nodes;
  std::vector<int> parents(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      int& parent = parents[std::size_t(child)];
      if (parent >= 0) {
        file.refuse(
            fmt::format("cannot be read as a mesh (node {} is a child of node {} and of node {})", child, parent, i));
      }
      parent = int(i);
    }
  }
  return parents;
}

class Walk {
 public:
  explicit Walk(const File& file) : file_(file) { order_.numbers.assign(file.model.nodes.size(), -1); }

  void add(int root) {
    std::vector<Step> steps{{root, -1, 1}};
    while (!steps.empty()) {
      const Step step = steps.back();
      steps.pop_back();
      int& number = order_.numbers[std::size_t(step.node)];
      if (number >= 0) refuse_circle(step.node);
      if (step.depth > kDeepest) file_.refuse(fmt::format("its nodes are nested more than {} deep", kDeepest));
      number = int(order_.places.size());
      order_.places.push_back({step.node, step.parent});
      const std::vector<int>& children = file_.model.nodes[std::size_t(step.node)].children;
      for (auto child = children.rbegin(); child != children.rend(); ++child) {
        steps.push_back({*child, number, step.depth + 1});
      }
    }
  }

  bool has(int node) const { return order_.numbers[std::size_t(node)] >= 0; }
  void end_of_scene() { order_.drawn = order_.places.size(); }
  NodeOrder take() { return std::move(order_); }
  [[noreturn]] void refuse_circle(int node) const {
    file_.refuse(fmt::format("cannot be read as a mesh (node {} is in a circle, or twice in the scene)", node));
  }

 private:
  struct Step {
    int node, parent, depth;
  };
  const File& file_;
  NodeOrder order_;
};

// The default scene; without one the first; without any all nodes that have no parent.
std::vector<int> roots_of(File* file, const std::vector<int>& parents) {
  const tinygltf::Model& model = file->model;
  if (model.scenes.size() > 1) {
    file->remark(fmt::format("of {} scenes the {} is drawn", model.scenes.size(),
                             model.defaultScene >= 0 ? "default one" : "first"));
  }
  if (!model.scenes.empty()) return model.scenes[std::size_t(std::max(model.defaultScene, 0))].nodes;
  std::vector<int> roots;
  for (std::size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] < 0) roots.push_back(int(i));
  }
  return roots;
}

// For animations, which glTF allows where there is no matrix, and exporters write all the same.
void take_apart(Node* node) {
  const glm::dmat3 linear(node->matrix);
  node->translation = node->matrix[3];
  node->scale = {glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])};
  if (glm::determinant(linear) < 0) node->scale.x = -node->scale.x;
  if (!(std::abs(node->scale.x * node->scale.y * node->scale.z) > 0)) return;
  const glm::dmat3 turn(linear[0] / node->scale.x, linear[1] / node->scale.y, linear[2] / node->scale.z);
  node->rotation = glm::normalize(glm::quat_cast(turn));
}

}  // namespace

NodeOrder order_of(File* file) {
  if (file->model.nodes.size() > kMostNodes) file->refuse(fmt::format("has more than {} nodes", kMostNodes));
  const std::vector<int> parents = parents_of(*file);
  Walk walk(*file);
  for (const int root : roots_of(file, parents)) walk.add(root);
  walk.end_of_scene();
  for (const tinygltf::Skin& skin : file->model.skins) {
    for (int joint : skin.joints) {
      int steps = 0;
      while (!walk.has(joint) && parents[std::size_t(joint)] >= 0) {
        joint = parents[std::size_t(joint)];
        if (++steps > kDeepest) walk.refuse_circle(joint);
      }
      if (!walk.has(joint)) walk.add(joint);
    }
  }
  return walk.take();
}

Node node_of(const File& file, int number) {
  const tinygltf::Node& source = file.model.nodes[std::size_t(number)];
  Node node;
  node.name = name_of(source.name);
  node.weights = source.weights;
  if (source.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) node.matrix[i / 4][i % 4] = source.matrix[std::size_t(i)];
    take_apart(&node);
    return node;
  }
  if (source.translation.size() == 3) {
    node.translation = {source.translation[0], source.translation[1], source.translation[2]};
  }
  if (source.scale.size() == 3) node.scale = {source.scale[0], source.scale[1], source.scale[2]};
  if (source.rotation.size() == 4) {
    node.rotation = glm::dquat(source.rotation[3], source.rotation[0], source.rotation[1], source.rotation[2]);
    if (!(glm::length(node.rotation) > 0)) {
      file.refuse(fmt::format("cannot be read as a mesh (node {} has a rotation of length 0)", number));
    }
    node.rotation = glm::normalize(node.rotation);
  }
  node.matrix = glm::scale(glm::translate(glm::dmat4(1), node.translation) * glm::mat4_cast(node.rotation), node.scale);
  return node;
}

}  // namespace halfspace::ref::gltf
