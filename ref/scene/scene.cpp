// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/builtin/animated_scenes.hpp"
#include "ref/builtin/builtin_scenes.hpp"
#include "ref/error.hpp"
#include "ref/scene/read_document.hpp"
#include "ref/scene/scene_at.hpp"

namespace halfspace::ref {
namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// What a file may hold is checked where it is read; a pose can still overflow.
void check_mesh(const Scene& scene, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (finite(mesh.positions[i])) continue;
    throw Error(
        fmt::format("{}: mesh '{}', vertex {}: a coordinate is NaN or infinite; export the file again without it",
                    scene.name, mesh.name, i));
  }
}

bool is_builtin(const std::string& name) {
  for (const auto& names : {builtin_scene_names(), animated_scene_names()}) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return true;
  }
  return false;
}

void check(const Scene& scene) {
  for (const Mesh& mesh : scene.meshes) check_mesh(scene, mesh);
  std::size_t triangles = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (int column = 0; column < 4; ++column) {
      if (finite(instance.to_world[column])) continue;
      throw Error(fmt::format("{}: mesh '{}' is placed by a matrix with NaN or infinity; export the file again",
                              scene.name, mesh.name));
    }
    triangles += mesh.triangles.size();
  }
  if (triangles == 0) throw Error(fmt::format("{}: there are no triangles in it; export a mesh of faces", scene.name));
}

}  // namespace

SceneSource::SceneSource(const std::string& name_or_path, const SceneChoice& choice)
    : name_(name_or_path), choice_(choice) {
  if (is_builtin(name_)) return;
  document_ = std::make_shared<const Document>(read_document(name_, choice_));
  framing_ = framing_of(*document_, choice_);
}

Scene SceneSource::at(double seconds) const {
  std::optional<Scene> scene;
  if (document_) {
    scene = scene_at(*document_, choice_, seconds, framing_);
  } else {
    scene = builtin_scene(name_);
    if (!scene) scene = animated_scene(name_, seconds, choice_.textured);
  }
  check(*scene);
  return std::move(*scene);
}

}  // namespace halfspace::ref
