// SPDX-License-Identifier: Apache-2.0
// Two flying machines of many parts, after the fighters of frame-rate up-conversion.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/builtin/animated_scenes.hpp"
#include "ref/builtin/builtin_scenes.hpp"
#include "ref/builtin/mesh_builder.hpp"

namespace halfspace::ref {
namespace {

constexpr double kPi = glm::pi<double>();
const glm::dmat4 kHere(1);

Material paint(double specular, double shininess) {
  Material material;
  material.ambient = material.diffuse = glm::dvec3(1);
  material.specular = glm::dvec3(specular);
  material.shininess = shininess;
  return material;
}

int add(Scene& scene, MeshBuilder&& builder, const char* name, int material) {
  scene.meshes.push_back(std::move(builder).mesh(name));
  scene.meshes.back().material = material;
  return static_cast<int>(scene.meshes.size()) - 1;
}

glm::dmat4 at(const glm::dvec3& place) { return glm::translate(kHere, place); }
glm::dmat4 turned(double angle, const glm::dvec3& axis) { return glm::rotate(kHere, angle, axis); }

// From rest to rest while `seconds` go from `from` to `to`.
double eased(double seconds, double from, double to) {
  const double t = glm::clamp((seconds - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Camera watcher() {
  Camera camera;
  camera.position = {0, 0.4, 8};
  camera.forward = {0, 0, -1};
  camera.half_height = 0.35;
  return camera;
}

}  // namespace

void add_drone(Scene& scene, const glm::dmat4& flight, double seconds) {
  constexpr double kArm = 1.15, kRotor = 300;  // degrees a second, neighbours the other way around
  const int paints = int(scene.materials.size());
  scene.materials.push_back(paint(0.3, 12)), scene.materials.push_back(paint(0.6, 24));

  MeshBuilder hull;
  hull.colour = {0.62, 0.66, 0.72};
  hull.ellipsoid({0, 0, 0}, {0.62, 0.42, 0.62}, 40, 20);
  hull.colour = {0.16, 0.30, 0.52};
  hull.ellipsoid({0, 0.1, 0.42}, {0.3, 0.26, 0.3}, 28, 14);
  for (int i = 0; i < 4; ++i) {
    const double a = kPi / 4 + i * kPi / 2;
    const glm::dvec3 out(std::cos(a), 0, std::sin(a)), side(-out.z, 0, out.x), up(0, 1, 0);
    hull.colour = {0.30, 0.32, 0.36};
    hull.block(0.5 * out - 0.06 * side - 0.05 * up, 0.55 * out, 0.1 * up, 0.12 * side);
    hull.colour = {0.85, 0.45, 0.15};
    hull.lathe(0.45 * out - 0.75 * up, {{0.05, 0}, {0.03, 0.5}}, 12);
  }
  const int hull_mesh = add(scene, std::move(hull), "hull", paints + 1);

  MeshBuilder duct;
  duct.colour = {0.86, 0.72, 0.25};
  duct.torus(0.62, 0.07, 36, 10);
  duct.colour = {0.30, 0.32, 0.36};
  duct.lathe({0, -0.1, 0}, {{0.1, 0}, {0.1, 0.16}, {0.04, 0.24}}, 16);
  const int duct_mesh = add(scene, std::move(duct), "duct", paints);

  MeshBuilder blade;
  blade.colour = {0.78, 0.20, 0.18};
  blade.block({0.08, 0.0, -0.07}, {0.45, 0, 0}, {0, 0.015, 0}, {0, 0.04, 0.14});
  const int blade_mesh = add(scene, std::move(blade), "blade", paints);

  scene.instances.push_back({hull_mesh, flight});
  for (int i = 0; i < 4; ++i) {
    const double a = kPi / 4 + i * kPi / 2, turn = glm::radians(kRotor) * seconds * (i % 2 ? -1 : 1);
    const glm::dmat4 hub = flight * at(kArm * 1.3 * glm::dvec3(std::cos(a), 0, std::sin(a)));
    scene.instances.push_back({duct_mesh, hub});
    for (int b = 0; b < 3; ++b)
      scene.instances.push_back({blade_mesh, hub * turned(turn + b * 2 * kPi / 3, {0, 1, 0})});
  }
}

// In from the left, then up and toward the viewer until parts of it are out of the picture.
Scene drone(double seconds) {
  Scene scene;
  scene.camera = watcher();
  const double in = eased(seconds, -0.6, 1.1), off = eased(seconds, 0.9, 2.3);
  const glm::dvec3 place(-8 + 7.6 * in + 0.6 * off, -0.7 + 0.3 * in + 1.7 * off, -1 + 5.2 * off);
  add_drone(scene,
            at(place) * turned(0.5 - 0.9 * in, {0, 1, 0}) * turned(0.35 * (1 - in) - 0.5 * off, {0, 0, 1}) *
                turned(0.25 + 0.3 * off, {1, 0, 0}),
            seconds);
  return scene;
}

// It stands on the roof of the keep, its rotors turning, then rises between the spires, and comes down before the gate.
Scene court(double seconds) {
  constexpr double kScale = 1.6;
  const glm::dvec3 roof(0, 14.5 + 0.75 * kScale, 0), above(0.5, 23, 1), out(7, 17, 22), gate(1, 6, 34);
  Scene scene = builtin_scene("castle").value();
  scene.framing = {{-11, 0, 26}, {11, 0, 26}, {-6, 25, 0}, {6, 25, 0}};
  const double t = eased(seconds, 0.5, 2.6), s = 1 - t;
  const glm::dvec3 place = s * s * s * roof + 3 * s * s * t * above + 3 * s * t * t * out + t * t * t * gate;
  add_drone(scene,
            at(place) * turned(0.4 - 1.2 * t, {0, 1, 0}) * turned(0.8 * t * s, {0, 0, 1}) *
                glm::scale(kHere, glm::dvec3(kScale)),
            seconds);
  return scene;
}

// Nose along y, up along z. Past the viewer from the left and afar, rolling, its wings swept back on the way.
Scene jet(double seconds) {
  Scene scene;
  scene.materials = {paint(0.35, 16), paint(0.7, 30)};
  scene.camera = watcher();

  MeshBuilder body;
  body.colour = {0.55, 0.60, 0.66};
  body.lathe({0, -2.4, 0},
             {{0.22, 0}, {0.34, 0.4}, {0.38, 1.2}, {0.38, 2.4}, {0.33, 3.2}, {0.22, 4.0}, {0.1, 4.7}, {0, 5.0}}, 40);
  body.colour = {0.20, 0.28, 0.40};
  body.ellipsoid({0, 0.95, 0.26}, {0.2, 0.75, 0.26}, 28, 16);
  body.colour = {0.48, 0.52, 0.58};
  for (const double side : {-1.0, 1.0}) {
    body.box({side * 0.5 - 0.2, -2.0, -0.28}, {side * 0.5 + 0.2, 0.7, 0.16});
    body.block({side * 0.5 - 0.03, -2.2, 0.14}, {0.06, 0, 0}, {0, 0.9, 0}, {side * 0.12, -0.5, 0.8});
  }
  const int body_mesh = add(scene, std::move(body), "body", 0);

  MeshBuilder nozzle;
  nozzle.colour = {0.28, 0.26, 0.26};
  nozzle.lathe({0, -0.55, 0}, {{0.13, 0}, {0.19, 0.15}, {0.22, 0.35}, {0.2, 0.6}}, 28);
  nozzle.colour = {0.95, 0.55, 0.20};
  nozzle.disc({0, -0.55, 0}, 0.13, 28, false);
  const int nozzle_mesh = add(scene, std::move(nozzle), "nozzle", 1);

  MeshBuilder wing;  // the right one, from its pivot
  wing.colour = {0.42, 0.50, 0.60};
  wing.block({0, -0.6, -0.04}, {2.3, -0.35, 0.03}, {0, 0.75, 0}, {0, 0, 0.06});
  wing.colour = {0.75, 0.25, 0.20};
  wing.lathe({2.3, -1.1, 0.01}, {{0, 0}, {0.05, 0.1}, {0.05, 0.8}, {0, 1.1}}, 14);
  const int wing_mesh = add(scene, std::move(wing), "wing", 0);

  MeshBuilder tail;
  tail.colour = {0.42, 0.50, 0.60};
  tail.block({0.6, -2.3, -0.1}, {0.9, -0.35, 0}, {0, 0.65, 0}, {0, 0, 0.05});
  const int tail_mesh = add(scene, std::move(tail), "tail plane", 0);

  MeshBuilder missile;
  missile.colour = {0.88, 0.88, 0.86};
  missile.lathe({0, -0.5, 0}, {{0.05, 0}, {0.06, 0.1}, {0.06, 0.8}, {0.035, 0.95}, {0, 1.05}}, 20);
  for (int i = 0; i < 4; ++i) {
    const glm::dvec3 out(std::cos(i * kPi / 2), 0, std::sin(i * kPi / 2)), side(-out.z, 0, out.x);
    missile.block(0.04 * out - 0.01 * side + glm::dvec3(0, -0.48, 0), 0.14 * out, {0, 0.2, 0}, 0.02 * side);
  }
  const int missile_mesh = add(scene, std::move(missile), "missile", 0);

  const glm::dvec3 from(-6, 1.4, -6), to(4.2, -0.4, 2), nose = glm::normalize(to - from);
  const glm::dvec3 right = glm::normalize(glm::cross(nose, {0, 1, 0})), up = glm::cross(right, nose);
  const glm::dvec3 place = glm::mix(from, to, seconds / 2 * (0.7 + 0.15 * seconds));
  const glm::dmat4 heading{{right, 0}, {nose, 0}, {up, 0}, {0, 0, 0, 1}};
  const glm::dmat4 flight = at(place) * heading * turned(1.4 * std::sin(1.7 * seconds) - 0.4, {0, 1, 0});
  const double sweep = glm::radians(10 + 40 * eased(seconds, 0.3, 1.7));
  scene.instances.push_back({body_mesh, flight});
  for (const double side : {1.0, -1.0}) {  // the left side is the right one, mirrored
    const glm::dmat4 half = flight * glm::scale(kHere, glm::dvec3(side, 1, 1));
    scene.instances.push_back({nozzle_mesh, half * at({0.5, -2, -0.06})});
    scene.instances.push_back({wing_mesh, half * at({0.6, -0.1, 0}) * turned(-sweep, {0, 0, 1})});
    scene.instances.push_back({tail_mesh, half});
    for (int i = 0; i < 3; ++i)
      scene.instances.push_back({missile_mesh, half * at({0.28 + 0.26 * i, -0.3 - 0.2 * i, -0.42})});
  }
  return scene;
}

}  // namespace halfspace::ref
