// SPDX-License-Identifier: Apache-2.0
// Solids for the built-in scenes. Colours are kept a vertex, so that a scene needs few materials.
#ifndef HALFSPACE_REF_BUILTIN_MESH_BUILDER_HPP_
#define HALFSPACE_REF_BUILTIN_MESH_BUILDER_HPP_

#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

class MeshBuilder {
 public:
  glm::dvec3 colour{0.8};  // of what comes next

  std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(mesh_.positions.size()); }
  std::uint32_t vertex(const glm::dvec3& position, const glm::dvec3& normal);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.push_back({a, b, c}); }

  // A flat convex polygon, counter-clockwise seen from outside, as a fan.
  void polygon(const std::vector<glm::dvec3>& corners);
  // A box from its lowest corner and its edges, right-handed.
  void block(const glm::dvec3& corner, const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z);
  void box(const glm::dvec3& low, const glm::dvec3& high);
  // The side of a body of revolution: the profile is (distance from the axis, height) from the bottom up. The
  // axis is parallel to y through `foot`; `sides` facets, smooth around, with a crease at each point of the
  // profile.
  void lathe(const glm::dvec3& foot, const std::vector<glm::dvec2>& profile, int sides);
  // A regular polygon around the same axis, facing up or down.
  void disc(const glm::dvec3& centre, double radius, int sides, bool up);

  // A torus around the y axis.
  void torus(double radius, double thickness, int around, int across);
  // Smooth, its poles up and down.
  void ellipsoid(const glm::dvec3& centre, const glm::dvec3& radii, int around, int bands);

  // A mesh alone in a scene.
  Scene scene(const Material&) &&;
  Mesh mesh(const char* name) &&;

 private:
  Mesh mesh_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_BUILTIN_MESH_BUILDER_HPP_
