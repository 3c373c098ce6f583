// SPDX-License-Identifier: Apache-2.0
#include "ref/builtin/box_texture.hpp"

#include <map>
#include <utility>

namespace halfspace::ref {
namespace {

constexpr int kSide = 64, kCourse = 16, kBrick = 32, kJoint = 2;  // texels
constexpr double kRepeat = 2;                                     // units of the mesh

std::uint32_t scrambled(std::uint32_t i) {
  i = (i ^ (i >> 16)) * 0x45d9f3bu;
  i = (i ^ (i >> 16)) * 0x45d9f3bu;
  return i ^ (i >> 16);
}

Texture bricks() {
  Texture texture{"bricks", kSide, kSide, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int course = y / kCourse, along = (x + course % 2 * kBrick / 2) % kSide;
      const int brick = course * kSide + along / kBrick;
      const bool joint = y % kCourse < kJoint || along % kBrick < kJoint;
      const int grain = int(scrambled(std::uint32_t(y * kSide + x)) % 17) - 8;
      const int tone = (joint ? 130 : 195 + int(scrambled(std::uint32_t(brick + 7919)) % 52)) + grain;
      texture.texels.push_back({std::uint8_t(tone), std::uint8_t(tone), std::uint8_t(tone)});
    }
  }
  return texture;
}

// The axis that a face faces most.
int axis_of(const Mesh& mesh, const std::array<std::uint32_t, 3>& face) {
  const glm::dvec3& p = mesh.positions[face[0]];
  const glm::dvec3 across = glm::abs(glm::cross(mesh.positions[face[1]] - p, mesh.positions[face[2]] - p));
  if (across.x >= across.y && across.x >= across.z) return 0;
  return across.y >= across.z ? 1 : 2;
}

void add_coordinates(Mesh& mesh) {
  Mesh out{mesh.name, {}, {}, {}, {}, {}, mesh.material};
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> vertex;  // of the old one, on an axis
  for (const auto& face : mesh.triangles) {
    const int axis = axis_of(mesh, face);
    auto& corners = out.triangles.emplace_back();
    for (int v = 0; v < 3; ++v) {
      const auto [known, added] = vertex.try_emplace({face[v], axis}, std::uint32_t(out.positions.size()));
      corners[v] = known->second;
      if (!added) continue;
      const glm::dvec3& p = mesh.positions[face[v]];
      out.positions.push_back(p);
      out.normals.push_back(mesh.normals[face[v]]);
      if (!mesh.colours.empty()) out.colours.push_back(mesh.colours[face[v]]);
      out.texture_coordinates.emplace_back(p[(axis + 1) % 3] / kRepeat, p[(axis + 2) % 3] / kRepeat);
    }
  }
  mesh = std::move(out);
}

}  // namespace

void add_box_texture(Scene& scene) {
  for (Mesh& mesh : scene.meshes) add_coordinates(mesh);
  for (Material& material : scene.materials) material.texture = 0;
  scene.textures = {bricks()};
}

}  // namespace halfspace::ref
