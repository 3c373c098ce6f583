// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/scene.hpp"

#include <fmt/format.h>

#include "ref/builtin/animated_scenes.hpp"
#include "ref/builtin/builtin_scenes.hpp"
#include "ref/error.hpp"
#include "ref/scene/scene_file.hpp"

namespace halfspace::ref {
namespace {

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void check_mesh(const Scene& scene, const Mesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (finite(mesh.positions[i])) continue;
    throw Error(
        fmt::format("{}: mesh '{}', vertex {}: a coordinate is NaN or infinite; export the file again without it",
                    scene.name, mesh.name, i));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t i : mesh.triangles[t]) {
      if (i < mesh.positions.size()) continue;
      throw Error(fmt::format("{}: mesh '{}', face {}: index {} is beyond its {} vertices; export the file again",
                              scene.name, mesh.name, t, i, mesh.positions.size()));
    }
  }
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

Scene load_scene(const std::string& name_or_path, double time_seconds, bool textured) {
  std::optional<Scene> scene = builtin_scene(name_or_path);
  if (!scene) scene = animated_scene(name_or_path, time_seconds, textured);
  if (!scene) scene = read_scene_file(name_or_path, time_seconds, textured);
  check(*scene);
  return std::move(*scene);
}

}  // namespace halfspace::ref
