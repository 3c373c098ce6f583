// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/instancing.hpp"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "ref/scene/gltf/file/accessor.hpp"

namespace halfspace::ref::gltf {

std::optional<std::vector<Node>> instances_of(const File& file, int node) {
  const tinygltf::ExtensionMap& extensions = file.model.nodes[std::size_t(node)].extensions;
  const auto found = extensions.find("EXT_mesh_gpu_instancing");
  if (found == extensions.end()) return std::nullopt;
  const tinygltf::Value& attributes = found->second.Get("attributes");
  std::vector<Node> instances;
  for (const char* name : {"TRANSLATION", "ROTATION", "SCALE"}) {
    if (!attributes.Has(name)) continue;
    const bool turns = name[0] == 'R';
    const Accessor accessor(file, attributes.Get(name).GetNumberAsInt(), name, {turns ? 4 : 3});
    if (instances.empty()) instances.resize(accessor.count());
    if (instances.size() != accessor.count()) accessor.refuse(fmt::format("is not of {} instances", instances.size()));
    for (std::size_t i = 0; i < instances.size(); ++i) {
      const glm::dvec3 three(accessor.at(i, 0), accessor.at(i, 1), accessor.at(i, 2));
      if (name[0] == 'T') instances[i].translation = three;
      if (name[0] == 'S') instances[i].scale = three;
      if (!turns) continue;
      const glm::dquat rotation(accessor.at(i, 3), three.x, three.y, three.z);
      if (!(glm::length(rotation) > 0)) accessor.refuse("has a rotation of length 0");
      instances[i].rotation = glm::normalize(rotation);
    }
  }
  for (Node& instance : instances) {
    instance.matrix = glm::scale(
        glm::translate(glm::dmat4(1), instance.translation) * glm::mat4_cast(instance.rotation), instance.scale);
  }
  return instances;
}

}  // namespace halfspace::ref::gltf
