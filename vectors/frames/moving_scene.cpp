// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/moving_scene.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "ref/builtin/mesh_builder.hpp"

namespace halfspace::model {

ref::Scene moving_scene(int objects) {
  ref::Scene scene;
  scene.name = "small";
  ref::Material plain, two_sided;
  two_sided.two_sided = true;
  scene.materials = {plain, two_sided};
  for (int n = 0; n < objects; ++n) {
    ref::MeshBuilder builder;
    const auto colour = [&](int i) { builder.colour = {0.2 + 0.05 * n, 0.9 - 0.05 * n, 0.3 * i}; };
    colour(0);
    const double r = 0.25 + 0.02 * n;
    if (n % 4 < 2) {
      builder.polygon({{-r, -r, 0}, {r, -r, 0}, {r, r, 0}, {-r, r, 0}});
      colour(1);
      builder.polygon({{-r, 0, 0}, {2 * r, 0, 0}, {r, r, 0}});  // in the same plane
    } else if (n % 4 == 2) {
      builder.block({-r, -r, -r}, {2 * r, 0, 0}, {0, 2 * r, 0}, {0, 0, 2 * r});
    } else {
      builder.ellipsoid({0, 0, 0}, glm::dvec3(n == 3 ? 0.01 : r), 5, 4);
    }
    scene.meshes.push_back(std::move(builder).mesh("part"));
    scene.meshes.back().material = n % 4 == 1;
    scene.instances.push_back({n, glm::dmat4(1)});
  }
  ref::MeshBuilder corner;
  corner.polygon({{-4, -4, -3}, {-3.5, -4, -3}, {-4, -3.5, -3}});
  scene.meshes.push_back(std::move(corner).mesh("corner"));
  scene.instances.push_back({objects, glm::dmat4(1)});
  ref::Camera camera;
  camera.position = {0, 0, 4};
  camera.half_height = 0.4;
  scene.camera = camera;
  scene.depth_planes = ref::DepthPlanes{1.5, 9};
  return scene;
}

glm::dmat4 SceneMotion::place() {
  constexpr double kDepths[] = {0, 0, 0.5, 0.5, -1, 2.2, 2.6};  // the last two reach through the near plane
  glm::dmat4 m =
      glm::translate(glm::dmat4(1), glm::dvec3(0.3 * below(7) - 0.9, 0.3 * below(5) - 0.6, kDepths[below(7)]));
  if (below(4) == 0) m = glm::rotate(m, 0.6 * below(10), glm::dvec3(0.3, 1, 0.2));
  if (below(6) == 0) m = glm::scale(m, glm::dvec3(-1, 1, 1));
  if (below(9) == 0) m = glm::scale(m, glm::dvec3(6));
  return m;
}

void SceneMotion::begin(ref::Scene& scene) {
  for (std::size_t n = 0; n < moving_.size(); ++n) scene.instances[n].to_world = place();
}

void SceneMotion::step(ref::Scene& scene) {
  for (std::size_t n = 0; n < moving_.size(); ++n) {
    if (moving_[n] ? below(4) == 0 : below(12) == 0) moving_[n] = !moving_[n];
    if (!moving_[n]) continue;
    const glm::dmat4 before = scene.instances[n].to_world;
    if (below(5) == 0 && n > 0)
      scene.instances[n].to_world = scene.instances[std::size_t(below(int(n)))].to_world;  // a tie
    while (scene.instances[n].to_world == before) scene.instances[n].to_world = place();
  }
}

void SceneMotion::move_viewer(ref::Scene& scene) {
  if (below(50) == 0) view_until_ = frame_ + 1 + below(4);
  if (frame_ < view_until_) {
    scene.camera->position = {0.2 * below(5) - 0.4, 0.1 * below(5), 4 + 0.3 * below(3)};
    if (below(3) == 0) scene.depth_planes->far = 9 + below(3);
  }
  ++frame_;
}

bool SceneMotion::dim(ref::Scene& scene) {
  if (below(100) != 0) return false;
  scene.ambient = glm::dvec3(0.05 * (1 + below(10)));
  return true;
}

}  // namespace halfspace::model
