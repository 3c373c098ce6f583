// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/clip.hpp"

#include <algorithm>

namespace halfspace::ref {
namespace {

// Always counted from the inner vertex, whichever way the edge is gone along: so neighbours agree to the last
// bit.
ClipVertex cross(const ClipVertex& inner, const ClipVertex& outer, const ClipPlane& plane) {
  const double in = glm::dot(plane, inner.position), out = glm::dot(plane, outer.position);
  const double t = in / (in - out);
  return {inner.position + t * (outer.position - inner.position), inner.weights + t * (outer.weights - inner.weights)};
}

}  // namespace

std::vector<ClipVertex> clip(std::vector<ClipVertex> polygon, const std::vector<ClipPlane>& planes) {
  std::vector<ClipVertex> kept;
  for (const ClipPlane& plane : planes) {
    const auto inside = [&](const ClipVertex& v) { return glm::dot(plane, v.position) >= 0; };
    if (std::all_of(polygon.begin(), polygon.end(), inside)) continue;
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const ClipVertex &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
      if (inside(from)) kept.push_back(from);
      if (inside(from) && !inside(to)) kept.push_back(cross(from, to, plane));
      if (!inside(from) && inside(to)) kept.push_back(cross(to, from, plane));
    }
    polygon.swap(kept);
  }
  return polygon;
}

bool outside_one(const std::vector<ClipVertex>& polygon, const std::vector<ClipPlane>& planes) {
  return std::any_of(planes.begin(), planes.end(), [&](const ClipPlane& plane) {
    return std::all_of(polygon.begin(), polygon.end(),
                       [&](const ClipVertex& v) { return glm::dot(plane, v.position) < 0; });
  });
}

}  // namespace halfspace::ref
