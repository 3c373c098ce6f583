// SPDX-License-Identifier: Apache-2.0
// The small built-in scenes, after the models of frame-rate up-conversion and index rendering.
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/builtin/builtin_scenes.hpp"
#include "ref/builtin/mesh_builder.hpp"

namespace halfspace::ref {
namespace {

constexpr double kPi = glm::pi<double>();

Material plastic(double specular, double shininess) {
  Material material;
  material.ambient = material.diffuse = glm::dvec3(1);
  material.specular = glm::dvec3(specular);
  material.shininess = shininess;
  return material;
}

}  // namespace

Scene cube() {
  MeshBuilder builder;
  const glm::dvec3 colours[6] = {{0.25, 0.55, 0.85}, {0.90, 0.30, 0.25}, {0.75, 0.45, 0.80},
                                 {0.95, 0.85, 0.35}, {0.95, 0.60, 0.20}, {0.35, 0.70, 0.40}};
  // Each axis in turn, its negative and its positive face.
  for (int face = 0; face < 6; ++face) {
    const int x = face / 2, y = (x + 1) % 3, z = (x + 2) % 3;
    const double side = face % 2 ? 1 : -1;
    glm::dvec3 outward(0), right(0), up(0);
    outward[x] = side, right[y] = side, up[z] = 1;
    builder.colour = colours[face];
    builder.polygon({outward - right - up, outward + right - up, outward + right + up, outward - right + up});
  }
  return std::move(builder).scene(plastic(0.2, 20));
}

Scene pyramid() {
  MeshBuilder builder;
  const glm::dvec3 colours[4] = {{0.90, 0.75, 0.35}, {0.80, 0.35, 0.25}, {0.30, 0.60, 0.70}, {0.50, 0.70, 0.35}};
  const glm::dvec3 base[4] = {{-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1}}, apex(0, 1.5, 0);
  for (int i = 0; i < 4; ++i) {
    builder.colour = colours[i];
    builder.polygon({base[i], base[(i + 1) % 4], apex});
  }
  builder.colour = glm::dvec3(0.5);
  builder.polygon({base[3], base[2], base[1], base[0]});
  return std::move(builder).scene(plastic(0, 0));
}

Scene ring() {
  MeshBuilder builder;
  builder.colour = {0.85, 0.62, 0.18};
  builder.torus(1, 0.36, 48, 24);
  Scene scene = std::move(builder).scene(plastic(0.7, 30));
  scene.view_direction = {-0.3, -0.75, -1};
  return scene;
}

// Made around the y axis and put upright, so that the hub points at z.
Scene wheel() {
  constexpr int kSpokes = 10;
  Scene scene;
  scene.materials = {plastic(0.15, 10), plastic(0.6, 30)};

  MeshBuilder tyre;
  tyre.colour = {0.22, 0.22, 0.25};
  tyre.torus(1.0, 0.17, 48, 16);
  scene.meshes.push_back(std::move(tyre).mesh("tyre"));

  MeshBuilder metal;
  metal.colour = {0.75, 0.20, 0.16};
  metal.lathe({0, 0, 0}, {{0.78, -0.13}, {0.88, -0.13}, {0.88, 0.13}, {0.78, 0.13}, {0.78, -0.13}}, 48);
  metal.colour = {0.80, 0.80, 0.84};
  metal.lathe({0, 0, 0}, {{0.16, -0.2}, {0.16, 0.2}, {0.10, 0.28}}, 32);
  metal.disc({0, 0.28, 0}, 0.10, 32, true);
  metal.disc({0, -0.2, 0}, 0.16, 32, false);
  scene.meshes.push_back(std::move(metal).mesh("rim and hub"));
  scene.meshes[1].material = 1;

  MeshBuilder spoke;
  spoke.colour = {0.85, 0.70, 0.25};
  spoke.box({0.1, -0.05, -0.04}, {0.8, 0.05, 0.04});
  scene.meshes.push_back(std::move(spoke).mesh("spoke"));
  scene.meshes[2].material = 1;

  const glm::dmat4 upright = glm::rotate(glm::dmat4(1), kPi / 2, glm::dvec3(1, 0, 0));
  scene.instances = {{0, upright}, {1, upright}};
  for (int i = 0; i < kSpokes; ++i) {
    scene.instances.push_back({2, glm::rotate(upright, 2 * kPi * i / kSpokes, glm::dvec3(0, 1, 0))});
  }
  scene.view_direction = {-0.6, -0.3, -1};
  return scene;
}

// The second triangle is seen from behind: neither is culled.
Scene polyhedron() {
  MeshBuilder builder;
  builder.colour = {0.95, 0.55, 0.15};
  builder.polygon({{-1.2, -0.9, 0.5}, {1.0, -0.6, -0.6}, {-0.1, 1.1, 0.1}});
  builder.colour = {0.20, 0.50, 0.90};
  builder.polygon({{-0.9, 0.8, -0.5}, {1.2, 0.6, 0.6}, {0.2, -1.1, 0.0}});
  Material material = plastic(0.2, 20);
  material.two_sided = true;
  Scene scene = std::move(builder).scene(material);
  scene.view_direction = {-0.1, -0.15, -1};
  return scene;
}

// A cube with a low roof on each side. Neighbours have different colours: on a side by turns, and of the two sides at
// an edge of the cube one has its first corners along it and the other its second. In the order of its sides, of which
// those behind come before and after those in front of them; none is culled.
Scene two_tone() {
  constexpr double kRoof = 1.5;
  MeshBuilder builder;
  for (int side = 0; side < 6; ++side) {
    const int x = side / 2, y = (x + 1) % 3, z = (x + 2) % 3;
    const double out = side % 2 ? 1 : -1;
    glm::dvec3 outward(0), right(0), up(0);
    outward[x] = out, right[y] = out, up[z] = 1;
    const glm::dvec3 corners[4] = {outward - right - up, outward + right - up, outward + right + up,
                                   outward - right + up};
    for (int i = 0; i < 4; ++i) {
      builder.colour = i % 2 == 0 ? glm::dvec3(0.95, 0.55, 0.15) : glm::dvec3(0.20, 0.50, 0.90);
      builder.polygon({corners[i], corners[(i + 1) % 4], kRoof * outward});
    }
  }
  Material material = plastic(0.2, 20);
  material.two_sided = true;
  return std::move(builder).scene(material);
}

}  // namespace halfspace::ref
