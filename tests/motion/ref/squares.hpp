// SPDX-License-Identifier: Apache-2.0
// Scenes of squares on a frame of 160 x 120 pixels, and frames of them between key frames.
#ifndef HALFSPACE_TESTS_MOTION_REF_SQUARES_HPP_
#define HALFSPACE_TESTS_MOTION_REF_SQUARES_HPP_

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "ref/motion/up_convert.hpp"

namespace halfspace::ref {

constexpr int kWidth = 160, kHeight = 120;
inline const UpConversion kPlain{kWidth, kHeight, {"frames", 0, 0, 16384, 14, 8, 24}};

// --- scenes: a unit is a pixel, (0, 0) the upper left corner of the frame ---

struct Square {
  double x, y, width, height;
  double depth = 0;  // nearer is more
  glm::dvec3 colour{0.8, 0.4, 0.2};
};

// Squares shine by themselves, in one colour or, if there is one, by the texture. A last one, one pixel, stands in the
// corner of the frame: a frame without any triangle is refused.
inline Scene squares(std::vector<Square> all, const std::optional<Texture>& texture = {}) {
  Scene scene;
  scene.name = "squares";
  scene.camera = Camera{};
  scene.camera->position = {kWidth / 2.0, -kHeight / 2.0, 50};
  scene.camera->orthographic = true, scene.camera->half_height = kHeight / 2.0;
  scene.camera->near = 1, scene.camera->far = 100;
  if (texture) scene.textures = {*texture};
  all.push_back({0, kHeight - 1, 1, 1});
  for (const Square& s : all) {
    Material material;
    material.ambient = material.diffuse = glm::dvec3(0), material.emission = s.colour;
    if (texture) material.texture = 0;
    Mesh mesh;
    mesh.material = int(scene.materials.size());
    for (const auto& [x, y] : {std::pair(0, 1), std::pair(1, 1), std::pair(1, 0), std::pair(0, 0)}) {
      mesh.positions.emplace_back(x * s.width, -y * s.height, 0);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.texture_coordinates.emplace_back(x, y);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.instances.push_back(
        {int(scene.meshes.size()), glm::translate(glm::dmat4(1), glm::dvec3(s.x, -s.y, s.depth))});
    scene.meshes.push_back(mesh);
    scene.materials.push_back(material);
  }
  return scene;
}

inline Texture noise(int side) {
  Texture texture{"noise", side, side, {}};
  std::uint32_t state = 1;
  for (int i = 0; i < side * side; ++i) {
    auto& texel = texture.texels.emplace_back();
    for (auto& channel : texel) channel = std::uint8_t((state = state * 1664525u + 1013904223u) >> 24);
  }
  return texture;
}

using At = std::function<Scene(double a)>;
inline FrameBetween between(const At& scene, double a, const UpConversion& mode) {
  return Interval(scene(0), scene(1), mode).at(scene(a), a);
}
inline int largest_difference(const Colours& a, const Colours& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[i][c] - b[i][c]));
  }
  return largest;
}
inline UpConversion with(Filter filter, UpConversion mode = kPlain) {
  mode.compensation.filter = filter;
  return mode;
}

inline UpConversion surfaces(UpConversion mode) {
  mode.surfaces = true;
  return mode;
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_MOTION_REF_SQUARES_HPP_
