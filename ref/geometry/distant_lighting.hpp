// SPDX-License-Identifier: Apache-2.0
// Lighting with lights and viewer at infinity, as hardware lights: L and H of a light, and what a material makes of it,
// are the same all over a frame. A point or spot light counts with the direction and the intensity that it has at the
// centre of the scene's bounding box, and so does the viewer. In doubles.
#ifndef HALFSPACE_REF_GEOMETRY_DISTANT_LIGHTING_HPP_
#define HALFSPACE_REF_GEOMETRY_DISTANT_LIGHTING_HPP_

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "ref/geometry/viewpoint.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

struct DistantLight {
  glm::dvec3 to_light;   // L, length 1
  glm::dvec3 half;       // H = (L + V) / |L + V|; 0 where the light shines straight at the viewer
  glm::dvec3 intensity;  // Ii
};

// In 0-255 a channel, and more where a light is brighter than 1.
struct DistantMaterial {
  glm::dvec3 base;     // of emission and ambient light
  int squarings;       // k: the exponent of the highlights is 2^k
  struct Reflection {  // of a light
    glm::dvec3 diffuse, specular;
  };
  std::vector<Reflection> reflections;
};

// A triangle has one material: that of its mesh, in the colour of its first vertex.
struct DistantTriangle {
  int material;
  std::array<glm::dvec3, 3> normals;  // in the world, length 1 or 0
};

struct DistantScene {
  std::vector<DistantLight> lights;
  std::vector<DistantMaterial> materials;  // as many as differ
  std::vector<DistantTriangle>
      triangles;                       // all of the scene; of a two-sided mesh each twice, seen from behind after it
  std::vector<std::uint32_t> of_face;  // where the triangle of face n of the scene, from 1 on, stands: at [n - 1]
};

// log2 of the exponent, to nearest and within 0 … most; −1, no highlights, for a shininess of 0.
int squarings(double shininess, int most);

// `most_squarings`: log2 of the largest exponent of a highlight; −1: there are none.
DistantScene distant_scene(const Scene&, const Viewpoint&, int most_squarings);

// Of a normal of any length:
//   I = base + sum of [ diffuse max(0, N·L) + (N·L > 0) specular max(0, N·H)^(2^k) ],  N = n / |n|, in 0-255, clamped
//   to it
glm::dvec3 distant_colour(const DistantMaterial&, const std::vector<DistantLight>&, const glm::dvec3& n);

class Geometry;
struct SnappedList;
// The triangles of a geometry, snapped, in the colours that their vertices have so.
SnappedList distantly_lit(SnappedList list, const Geometry&, int most_squarings);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_DISTANT_LIGHTING_HPP_
