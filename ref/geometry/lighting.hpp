// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_GEOMETRY_LIGHTING_HPP_
#define HALFSPACE_REF_GEOMETRY_LIGHTING_HPP_

#include <glm/glm.hpp>
#include <vector>

#include "ref/geometry/viewpoint.hpp"
#include "ref/scene/normals.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// A point of a surface, in the world.
struct SurfacePoint {
  glm::dvec3 position, normal;  // length 1
  glm::dvec3 to_viewer;         // V, length 1
  glm::dvec3 colour;            // multiplies Ka and Kd
};

// A vertex of a mesh that is placed by `to_world`, whose normal matrix is `turn`; `back`: of a face that is seen from
// behind.
glm::dvec3 placed_normal(const Mesh&, std::uint32_t vertex, const glm::dmat3& turn, bool back);
SurfacePoint placed_vertex(const Mesh&, std::uint32_t vertex, const glm::dmat4& to_world, const glm::dmat3& turn,
                           bool back, const Viewpoint&);

// How a light arrives at a point.
struct Arrival {
  glm::dvec3 to_light;   // L, length 1
  glm::dvec3 intensity;  // Ii as it arrives
};
Arrival arrive(const Light&, const glm::dvec3& point);

// The scene's lights; where it has none, one from the upper left behind the viewer.
std::vector<Light> lights_of(const Scene&, const Viewpoint&);

// The Phong model of index rendering, in 0-255 a channel and clamped to it:
//   I = emission + Ia Ka + sum of Ii (Kd (L·N) + Ks (H·N)^n),  H = (L + V) / |L + V|,
// for lights with L·N > 0. Of an unlit material I = Kd.
glm::dvec3 phong(const SurfacePoint&, const Material&, const glm::dvec3& ambient, const std::vector<Light>&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_LIGHTING_HPP_
