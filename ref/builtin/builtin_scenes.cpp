// SPDX-License-Identifier: Apache-2.0
#include "ref/builtin/builtin_scenes.hpp"

namespace halfspace::ref {
namespace {

constexpr struct {
  const char* name;
  Scene (*make)();
} kScenes[] = {{"teapot", teapot}, {"cube", cube},     {"pyramid", pyramid},       {"wheel", wheel},
               {"ring", ring},     {"castle", castle}, {"polyhedron", polyhedron}, {"two_tone", two_tone}};

}  // namespace

std::vector<std::string> builtin_scene_names() {
  std::vector<std::string> names;
  for (const auto& scene : kScenes) names.push_back(scene.name);
  return names;
}

std::optional<Scene> builtin_scene(const std::string& name) {
  for (const auto& known : kScenes) {
    if (name != known.name) continue;
    Scene scene = known.make();
    scene.name = name;
    for (const Instance& instance : scene.instances) {
      const Mesh& mesh = scene.meshes[instance.mesh];
      for (const glm::dvec3& p : mesh.positions) scene.framing.emplace_back(instance.to_world * glm::dvec4(p, 1));
    }
    return scene;
  }
  return std::nullopt;
}

}  // namespace halfspace::ref
