// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/scene_at.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

#include "ref/error.hpp"
#include "ref/scene/box.hpp"
#include "ref/scene/normals.hpp"
#include "ref/scene/placed_parts.hpp"
#include "ref/scene/pose.hpp"

namespace halfspace::ref {
namespace {

constexpr int kFramedTimes = 32;  // of an animation, at which its corners are in view

// By name, or by number from 0 on; −1: none.
template <class Named>
int find(const std::vector<Named>& all, const std::string& wanted) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == wanted) return int(i);
  }
  int number = -1;
  const char* const end = wanted.data() + wanted.size();
  const auto [rest, error] = std::from_chars(wanted.data(), end, number);
  return error == std::errc() && rest == end && number >= 0 && number < int(all.size()) ? number : -1;
}

template <class Named>
std::string names_of(const std::vector<Named>& all) {
  std::string names;
  for (std::size_t i = 0; i < all.size() && i < 10; ++i)
    names += fmt::format("{}{} '{}'", i ? ", " : "", i, all[i].name);
  return all.size() > 10 ? names + ", …" : names;
}

template <class Named>
int chosen(const Document& document, const std::vector<Named>& all, const std::string& wanted, const char* option) {
  if (wanted.empty()) return all.empty() ? -1 : 0;
  const int number = find(all, wanted);
  if (number >= 0) return number;
  throw Error(fmt::format("{}: --{} {}: it has none of that name or number: {}", document.name, option, wanted,
                          all.empty() ? "leave the option out, as it has none at all" : "take " + names_of(all)));
}

void add_instance(const Document& document, const Pose& pose, int node, int number, Scene* scene) {
  const DocumentMesh& source = document.meshes[number];
  const int of_skin = document.nodes[node].skin >= 0 ? document.nodes[node].skin : source.skin;
  const bool is_skinned = of_skin >= 0 && !source.joint_weights.empty();
  if (!is_skinned && source.targets.empty()) {
    scene->instances.push_back({number, pose.to_world(node)});
    return;
  }
  Mesh moved = source.mesh;
  if (!source.targets.empty()) morph(source, pose.weights(node, source), &moved);
  if (is_skinned) skin(source, document.skins[of_skin], pose, pose.to_world(node), &moved);
  if (source.is_flat) make_flat(&moved);
  scene->instances.push_back({int(scene->meshes.size()), is_skinned ? glm::dmat4(1) : pose.to_world(node)});
  scene->meshes.push_back(std::move(moved));
}

Scene geometry_at(const Document& document, const Pose& pose) {
  Scene scene;
  for (const DocumentMesh& mesh : document.meshes) {
    scene.meshes.push_back(mesh.mesh);
    if (mesh.is_flat) make_flat(&scene.meshes.back());
  }
  for (int n = 0; n < int(document.nodes.size()); ++n) {
    for (const int mesh : document.nodes[n].meshes) add_instance(document, pose, n, mesh, &scene);
  }
  return scene;
}

// The corners of all that is drawn. Meshes that do not change are not copied.
std::vector<glm::dvec3> world_points(const Document& document, const Pose& pose) {
  std::vector<glm::dvec3> points;
  for (int n = 0; n < int(document.nodes.size()); ++n) {
    for (const int number : document.nodes[n].meshes) {
      Scene moved;
      add_instance(document, pose, n, number, &moved);
      const Mesh& mesh = moved.meshes.empty() ? document.meshes[number].mesh : moved.meshes[0];
      const glm::dmat4& to_world = moved.instances[0].to_world;
      if (points.empty()) points.reserve(3 * mesh.triangles.size());
      for (const auto& corner : mesh.triangles) {
        for (const std::uint32_t i : corner) points.emplace_back(to_world * glm::dvec4(mesh.positions[i], 1));
      }
    }
  }
  return points;
}

void add_camera(const Document& document, const SceneChoice& choice, const Pose& pose, Scene* scene) {
  if (choice.camera == "auto") return;
  const int number = chosen(document, document.cameras, choice.camera, "camera");
  if (number < 0) return;
  if (choice.camera.empty() && document.cameras.size() > 1) {
    scene->remarks.push_back(fmt::format("{} cameras, of which the first is taken; --camera takes another: {}",
                                         document.cameras.size(), names_of(document.cameras)));
  }
  scene->camera = placed_camera(document.cameras[number], pose);
  if (scene->camera && document.cameras[number].is_doubtful && !sees(*scene->camera, scene->framing)) {
    scene->camera.reset();
    scene->remarks.push_back(fmt::format("its camera '{}' has nothing in view, and all of the scene is framed instead",
                                         document.cameras[number].name));
  } else if (!scene->camera) {
    scene->remarks.push_back(fmt::format("its camera '{}' has no direction, and all of the scene is framed instead",
                                         document.cameras[number].name));
  }
}

}  // namespace

const Animation* chosen_animation(const Document& document, const SceneChoice& choice) {
  const int number = chosen(document, document.animations, choice.animation, "animation");
  return number < 0 ? nullptr : &document.animations[number];
}

std::vector<glm::dvec3> framing_of(const Document& document, const SceneChoice& choice) {
  const Animation* const animation = chosen_animation(document, choice);
  std::vector<glm::dvec3> framing = world_points(document, Pose(document, animation, 0));
  if (!animation || !(animation->duration > 0)) return framing;
  for (int k = 1; k <= kFramedTimes; ++k) {
    const Pose pose(document, animation, animation->duration * k / kFramedTimes);
    const std::vector<glm::dvec3> points = world_points(document, pose);
    if (points.empty()) continue;
    const auto [low, high] = box_of(points);
    for (int c = 0; c < 8; ++c)
      framing.emplace_back(c & 1 ? high.x : low.x, c & 2 ? high.y : low.y, c & 4 ? high.z : low.z);
  }
  return framing;
}

Scene scene_at(const Document& document, const SceneChoice& choice, double seconds, std::vector<glm::dvec3> framing) {
  const Animation* const animation = chosen_animation(document, choice);
  const Pose pose(document, animation, seconds);
  Scene scene = geometry_at(document, pose);
  scene.name = document.name;
  scene.remarks = document.remarks;
  scene.framing = std::move(framing);
  scene.duration = animation ? animation->duration : 0;
  if (choice.animation.empty() && document.animations.size() > 1) {
    scene.remarks.push_back(fmt::format("{} animations, of which the first moves; --animation takes another: {}",
                                        document.animations.size(), names_of(document.animations)));
  }
  scene.materials = document.materials;
  scene.textures = document.textures;
  scene.materials.emplace_back();  // light grey, for meshes without one
  for (Material& material : scene.materials) material.two_sided |= choice.two_sided;
  for (Mesh& mesh : scene.meshes) {
    if (mesh.material < 0 || mesh.material >= int(scene.materials.size()))
      mesh.material = int(scene.materials.size()) - 1;
  }
  add_camera(document, choice, pose, &scene);
  add_placed_lights(document, pose, &scene);
  return scene;
}

}  // namespace halfspace::ref
