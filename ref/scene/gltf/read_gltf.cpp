// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/read_gltf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/scene/gltf/file/file.hpp"
#include "ref/scene/gltf/instancing.hpp"
#include "ref/scene/gltf/meshes.hpp"
#include "ref/scene/gltf/motion.hpp"
#include "ref/scene/gltf/nodes.hpp"
#include "ref/scene/gltf/views.hpp"

namespace halfspace::ref {
namespace gltf {
namespace {

class Reader {
 public:
  Reader(const std::string& path, const ReadChoice& choice)
      : file_(path, choice), document_(file_.document), meshes_(&file_), order_(order_of(&file_)) {
    document_.name = path;
  }

  Document read() {
    for (std::size_t i = 0; i < order_.places.size(); ++i) {
      document_.nodes.push_back(node_of(file_, order_.places[i].node));
      document_.nodes.back().parent = order_.places[i].parent;
      targets_.push_back(0);
    }
    for (std::size_t i = 0; i < order_.drawn; ++i) add_what_stands_at(int(i));
    sort_by_number(&document_.cameras, cameras_);
    sort_by_number(&document_.lights, lights_);
    for (std::size_t i = 0; i < file_.model.skins.size(); ++i) {
      document_.skins.push_back(skin_of(file_, int(i), order_));
    }
    for (std::size_t i = 0; i < file_.model.animations.size(); ++i) {
      document_.animations.push_back(animation_of(&file_, int(i), order_, targets_));
    }
    meshes_.say_what_is_left_out();
    return std::move(document_);
  }

 private:
  void add_what_stands_at(int number) {
    const int of = order_.places[std::size_t(number)].node;
    const tinygltf::Node& source = file_.model.nodes[std::size_t(of)];
    if (source.mesh >= 0) add_mesh(number, of, source);
    if (source.camera >= 0) {
      DocumentCamera camera = camera_of(file_, source.camera);
      if (camera.name.empty()) camera.name = document_.nodes[std::size_t(number)].name;
      camera.node = number;
      document_.cameras.push_back(camera);
      cameras_.push_back(source.camera);
    }
    const int light = light_number(file_, of);
    if (light < 0) return;
    if (const std::optional<Light> shines = light_of(file_, light)) {
      document_.lights.push_back({number, *shines});
      lights_.push_back(light);
    }
  }

  void add_mesh(int number, int of, const tinygltf::Node& source) {
    const MeshParts& parts = meshes_.of(source.mesh);
    Node& node = document_.nodes[std::size_t(number)];
    targets_[std::size_t(number)] = parts.targets;
    if (!node.weights.empty() && node.weights.size() != parts.targets) {
      file_.refuse(fmt::format("cannot be read as a mesh (node {} has {} weights of {} targets)", of,
                               node.weights.size(), parts.targets));
    }
    if (source.skin >= 0) {
      const std::size_t joints = file_.model.skins[std::size_t(source.skin)].joints.size();
      if (parts.joints > int(joints)) {
        file_.refuse(fmt::format("cannot be read as a mesh (mesh {} is moved by joint {} of {})", source.mesh,
                                 parts.joints - 1, joints));
      }
      node.skin = source.skin;
    }
    std::optional<std::vector<Node>> instances = instances_of(file_, of);
    if (!instances) {
      node.meshes = parts.numbers;
      return;
    }
    const std::vector<double> weights = node.weights;
    for (Node& instance : *instances) {
      instance.parent = number;
      instance.weights = weights;
      instance.meshes = parts.numbers;
      document_.nodes.push_back(std::move(instance));
      targets_.push_back(0);
    }
  }

  // As the file numbers them: the first is the first of the file, wherever it stands.
  template <class Item>
  static void sort_by_number(std::vector<Item>* items, const std::vector<int>& numbers) {
    std::vector<std::size_t> order(items->size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return numbers[a] < numbers[b]; });
    std::vector<Item> sorted;
    for (const std::size_t i : order) sorted.push_back((*items)[i]);
    *items = std::move(sorted);
  }

  File file_;
  Document& document_;
  Meshes meshes_;
  const NodeOrder order_;
  std::vector<std::size_t> targets_;  // of the mesh of each node of the document
  std::vector<int> cameras_, lights_;
};

}  // namespace
}  // namespace gltf

Document read_gltf(const std::string& path, const ReadChoice& choice) { return gltf::Reader(path, choice).read(); }

}  // namespace halfspace::ref
