// SPDX-License-Identifier: Apache-2.0
#include "ref/builtin/mesh_builder.hpp"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace halfspace::ref {
namespace {

constexpr double kPi = glm::pi<double>();

// Corner i of n around the y axis, from x to z: clockwise seen from above.
glm::dvec3 around(int i, int n) {
  const double angle = 2 * kPi * (i % n) / n;
  return {std::cos(angle), 0, std::sin(angle)};
}

}  // namespace

std::uint32_t MeshBuilder::vertex(const glm::dvec3& position, const glm::dvec3& normal) {
  mesh_.positions.push_back(position);
  mesh_.normals.push_back(normal);
  mesh_.colours.push_back(colour);
  return vertex_count() - 1;
}

void MeshBuilder::polygon(const std::vector<glm::dvec3>& corners) {
  const glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const std::uint32_t first = vertex_count();
  for (const glm::dvec3& corner : corners) vertex(corner, normal);
  for (std::uint32_t i = 2; i < corners.size(); ++i) triangle(first, first + i - 1, first + i);
}

void MeshBuilder::block(const glm::dvec3& corner, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
  const auto at = [&](int i) { return corner + double(i & 1) * x + double(i >> 1 & 1) * y + double(i >> 2) * z; };
  constexpr int kFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& face : kFaces) polygon({at(face[0]), at(face[1]), at(face[2]), at(face[3])});
}

void MeshBuilder::box(const glm::dvec3& low, const glm::dvec3& high) {
  const glm::dvec3 size = high - low;
  block(low, {size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z});
}

void MeshBuilder::lathe(const glm::dvec3& foot, const std::vector<glm::dvec2>& profile, int sides) {
  for (std::size_t p = 1; p < profile.size(); ++p) {
    const glm::dvec2 low = profile[p - 1], high = profile[p];
    const glm::dvec2 slope = glm::normalize(glm::dvec2(high.y - low.y, low.x - high.x));  // (outward, upward)
    for (int i = 0; i < sides; ++i) {
      const glm::dvec3 a = around(i, sides), b = around(i + 1, sides), up(0, 1, 0);
      const glm::dvec3 normal_a = slope.x * a + slope.y * up, normal_b = slope.x * b + slope.y * up;
      const std::uint32_t low_a = vertex(foot + low.x * a + low.y * up, normal_a);
      const std::uint32_t low_b = vertex(foot + low.x * b + low.y * up, normal_b);
      const std::uint32_t high_a = vertex(foot + high.x * a + high.y * up, normal_a);
      const std::uint32_t high_b = vertex(foot + high.x * b + high.y * up, normal_b);
      if (low.x != 0) triangle(low_a, high_a, low_b);
      if (high.x != 0) triangle(high_a, high_b, low_b);
    }
  }
}

void MeshBuilder::disc(const glm::dvec3& centre, double radius, int sides, bool up) {
  std::vector<glm::dvec3> corners;
  corners.reserve(std::size_t(sides));
  for (int i = 0; i < sides; ++i) corners.push_back(centre + radius * around(up ? sides - i : i, sides));
  polygon(corners);
}

void MeshBuilder::torus(double radius, double thickness, int around, int across) {
  const auto first = vertex_count();
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2 * kPi * i / around, b = 2 * kPi * j / across;
      const glm::dvec3 outward(std::cos(a), 0, std::sin(a));
      const glm::dvec3 normal = std::cos(b) * outward + std::sin(b) * glm::dvec3(0, 1, 0);
      vertex(radius * outward + thickness * normal, normal);
    }
  }
  const auto at = [&](int i, int j) { return first + std::uint32_t(i % around * across + j % across); };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      triangle(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      triangle(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  }
}

void MeshBuilder::ellipsoid(const glm::dvec3& centre, const glm::dvec3& radii, int around, int bands) {
  const auto first = vertex_count();
  for (int i = 0; i <= bands; ++i) {
    for (int j = 0; j < around; ++j) {
      const double up = kPi * i / bands - kPi / 2, a = 2 * kPi * j / around;
      const glm::dvec3 unit(std::cos(up) * std::cos(a), std::sin(up), std::cos(up) * std::sin(a));
      vertex(centre + radii * unit, glm::normalize(unit / radii));
    }
  }
  const auto at = [&](int i, int j) { return first + std::uint32_t(i * around + j % around); };
  for (int i = 0; i < bands; ++i) {
    for (int j = 0; j < around; ++j) {
      if (i > 0) triangle(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + 1 < bands) triangle(at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
    }
  }
}

Mesh MeshBuilder::mesh(const char* name) && {
  mesh_.name = name;
  return std::move(mesh_);
}

Scene MeshBuilder::scene(const Material& material) && {
  Scene scene;
  scene.materials = {material};
  scene.meshes.push_back(std::move(*this).mesh("solid"));
  scene.instances = {{0, glm::dmat4(1)}};
  return scene;
}

}  // namespace halfspace::ref
