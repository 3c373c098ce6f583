// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "ref/builtin/builtin_scenes.hpp"
#include "ref/builtin/mesh_builder.hpp"

namespace halfspace::ref {
namespace {

// The stored patches stand for themselves and for their images: in the plane y = 0, or in x = 0 and y = 0.
enum class Mirror { kY, kXY };
struct Patch {
  Mirror mirror;
  int points[16];
};
#include "ref/builtin/teapot_patches.inc"

constexpr int kQuads = 7;  // each way

// Bernstein polynomials of degree 3 and their derivatives.
std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}
std::array<double, 4> bernstein_slope(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

class Surface {
 public:
  Surface(const Patch& patch, double sign_x, double sign_y) {
    for (int i = 0; i < 16; ++i) {
      const auto& [x, y, z] = kPoints[patch.points[i]];
      control_[i] = {sign_x * x, z, -sign_y * y};  // z up to y up
    }
  }

  glm::dvec3 position(double u, double v) const { return sum(bernstein(u), bernstein(v)); }

  glm::dvec3 normal(double u, double v) const {
    glm::dvec3 along_u = sum(bernstein_slope(u), bernstein(v));
    glm::dvec3 along_v = sum(bernstein(u), bernstein_slope(v));
    // Where an edge of the patch is a single point its tangent is zero. Inward of the edge the tangent is the
    // mixed derivative times the distance, which has its direction.
    const glm::dvec3 mixed = sum(bernstein_slope(u), bernstein_slope(v));
    if (glm::length(along_u) < 1e-9) along_u = v < 0.5 ? mixed : -mixed;
    if (glm::length(along_v) < 1e-9) along_v = u < 0.5 ? mixed : -mixed;
    return glm::normalize(glm::cross(along_u, along_v));
  }

 private:
  glm::dvec3 sum(const std::array<double, 4>& of_u, const std::array<double, 4>& of_v) const {
    glm::dvec3 total(0);
    for (int i = 0; i < 16; ++i) total += of_v[i / 4] * of_u[i % 4] * control_[i];
    return total;
  }

  glm::dvec3 control_[16];
};

// A reflection turns the patch inside out: normals and windings are turned back.
void add_patch(MeshBuilder& builder, const Patch& patch, double sign_x, double sign_y) {
  const Surface surface(patch, sign_x, sign_y);
  const bool turned = sign_x * sign_y < 0;
  std::uint32_t grid[kQuads + 1][kQuads + 1];
  for (int i = 0; i <= kQuads; ++i) {
    for (int j = 0; j <= kQuads; ++j) {
      const double u = double(j) / kQuads, v = double(i) / kQuads;
      grid[i][j] = builder.vertex(surface.position(u, v), surface.normal(u, v) * (turned ? -1.0 : 1.0));
    }
  }
  for (int i = 0; i < kQuads; ++i) {
    for (int j = 0; j < kQuads; ++j) {
      std::uint32_t a = grid[i][j], b = grid[i][j + 1], c = grid[i + 1][j + 1], d = grid[i + 1][j];
      if (turned) std::swap(b, d);
      builder.triangle(a, b, c);
      builder.triangle(a, c, d);
    }
  }
}

}  // namespace

Scene teapot() {
  MeshBuilder builder;
  builder.colour = glm::dvec3(1);
  for (const Patch& patch : kPatches) {
    for (const double sign_y : {1.0, -1.0}) {
      add_patch(builder, patch, 1, sign_y);
      if (patch.mirror == Mirror::kXY) add_patch(builder, patch, -1, sign_y);
    }
  }
  Material brass;
  brass.ambient = {0.50, 0.36, 0.16};
  brass.diffuse = {0.78, 0.57, 0.20};
  brass.specular = {0.85, 0.78, 0.55};
  brass.shininess = 40;
  Scene scene = std::move(builder).scene(brass);
  scene.view_direction = {-0.28, -0.45, -1};
  return scene;
}

}  // namespace halfspace::ref
