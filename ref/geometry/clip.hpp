// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_GEOMETRY_CLIP_HPP_
#define HALFSPACE_REF_GEOMETRY_CLIP_HPP_

#include <glm/glm.hpp>
#include <vector>

namespace halfspace::ref {

// A vertex before the division by w: the view volume is -w <= x, y <= w and 0 <= z <= w, y up.
struct ClipVertex {
  glm::dvec4 position;
  glm::dvec3 weights;  // of the vertices of the face that it is cut from
};

// Inside is dot(plane, position) >= 0.
using ClipPlane = glm::dvec4;

// The part of a convex polygon inside all planes (Sutherland and Hodgman); empty if there is none. Triangles
// that share an edge get the same new vertices on it.
std::vector<ClipVertex> clip(std::vector<ClipVertex> polygon, const std::vector<ClipPlane>& planes);

// Are all vertices outside one plane?
bool outside_one(const std::vector<ClipVertex>& polygon, const std::vector<ClipPlane>& planes);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_CLIP_HPP_
