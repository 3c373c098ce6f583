// SPDX-License-Identifier: Apache-2.0
// What is drawn of a face: the triangles of the polygon that clipping has left of it, as they are divided and culled.
#ifndef HALFSPACE_REF_GEOMETRY_FACE_PARTS_HPP_
#define HALFSPACE_REF_GEOMETRY_FACE_PARTS_HPP_

#include <array>
#include <vector>

#include "ref/geometry/clip.hpp"
#include "ref/geometry/projection.hpp"

namespace halfspace::ref {

// Of a triangle clipped by six planes: at most nine vertices, seven parts.
constexpr int kMostParts = 8;

struct FacePart {
  int number;  // from 0 on, those that are culled counted
  std::array<Vertex, 3> triangle;
  std::array<const ClipVertex*, 3> from;
};

template <class Emit>
void face_parts(const std::vector<ClipVertex>& polygon, bool two_sided, const View& view, Emit&& emit) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    FacePart part{int(i) - 2, {}, {&polygon[0], &polygon[i - 1], &polygon[i]}};
    for (int v = 0; v < 3; ++v) part.triangle[v] = viewport(part.from[v]->position, view);
    if (two_sided || !view.culls || faces_viewer(part.triangle, view)) emit(part);
  }
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_FACE_PARTS_HPP_
