// SPDX-License-Identifier: Apache-2.0
// A triangle put in order, and the exact plane of an attribute over it.
#ifndef HALFSPACE_REF_GEOMETRY_PLANE_HPP_
#define HALFSPACE_REF_GEOMETRY_PLANE_HPP_

#include <array>
#include <cstdint>
#include <utility>

#include "ref/geometry/snap.hpp"

namespace halfspace::ref {

__extension__ typedef __int128 Wide;

// Rounded toward minus infinity, for b > 0.
template <class T>
constexpr T floor_div(T a, T b) {
  return a / b - (a % b < 0);
}

// Vertices in units of 2^-f pixels, ordered so that D, twice the area, is not negative.
struct OrderedTriangle {
  std::array<std::int64_t, 3> x, y;
  std::array<int, 3> vertex;  // which of the triangle each is
  std::int64_t area;          // D
  bool front;                 // D was negative as they came: counter-clockwise, as rows go downward

  explicit OrderedTriangle(const SnappedTriangle& t) : vertex{0, 1, 2} {
    const auto cross = [&](int a, int b, int c) {
      return (std::int64_t(t.x[b]) - t.x[a]) * (std::int64_t(t.y[c]) - t.y[a]) -
             (std::int64_t(t.y[b]) - t.y[a]) * (std::int64_t(t.x[c]) - t.x[a]);
    };
    area = cross(0, 1, 2);
    front = area < 0;
    if (front) {
      area = -area;
      std::swap(vertex[1], vertex[2]);
    }
    for (int i = 0; i < 3; ++i) x[i] = t.x[vertex[i]], y[i] = t.y[vertex[i]];
  }

  // Whether it is of the side that is dropped; one without an area is of none.
  bool is_culled(Cull which) const { return area != 0 && which != Cull::kNone && front == (which == Cull::kFront); }

  // The edge function of the edge from vertex i to the next, at a point in the same units: not negative on the inner
  // side. A point of the edge itself is inside only if the edge is a left or a top one, so that a centre on a
  // shared edge belongs to one triangle; the others are moved by the smallest step there is.
  std::int64_t edge(int i, std::int64_t px, std::int64_t py) const {
    const int j = (i + 1) % 3;
    const std::int64_t dx = x[j] - x[i], dy = y[j] - y[i];
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    return dx * (py - y[i]) - dy * (px - x[i]) - (top_left ? 0 : 1);
  }
};

// What each vertex of the triangle, in its own order, counts at a point: exact edge functions over D, none negative at
// a covered centre, so that nothing cancels on slivers. D is not 0.
inline std::array<double, 3> vertex_weights(const OrderedTriangle& t, std::int64_t px, std::int64_t py) {
  std::array<double, 3> weights;
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const std::int64_t area = (t.x[b] - t.x[a]) * (py - t.y[a]) - (t.y[b] - t.y[a]) * (px - t.x[a]);
    weights[t.vertex[i]] = double(area) / double(t.area);
  }
  return weights;
}

// V(p) = v0 + (N_A (px - x0) + N_B (py - y0)) / D with
//   N_A = (v1 - v0)(y2 - y0) - (v2 - v0)(y1 - y0),  N_B = (v2 - v0)(x1 - x0) - (v1 - v0)(x2 - x0),
// the Gouraud planes of the dual pipeline over one denominator. All in integers: on a sliver the terms are
// larger than V by the inverse of its area, and doubles would cancel.
struct Plane {
  const OrderedTriangle& triangle;
  std::int64_t v0, step_x, step_y;  // N_A and N_B

  Plane(const OrderedTriangle& t, const std::array<std::int64_t, 3>& of_vertex) : triangle(t) {
    v0 = of_vertex[t.vertex[0]];
    const std::int64_t dv1 = of_vertex[t.vertex[1]] - v0, dv2 = of_vertex[t.vertex[2]] - v0;
    step_x = dv1 * (t.y[2] - t.y[0]) - dv2 * (t.y[1] - t.y[0]);
    step_y = dv2 * (t.x[1] - t.x[0]) - dv1 * (t.x[2] - t.x[0]);
  }

  // V times D.
  Wide numerator(std::int64_t px, std::int64_t py) const {
    return Wide(v0) * triangle.area + Wide(step_x) * (px - triangle.x[0]) + Wide(step_y) * (py - triangle.y[0]);
  }
  double exact(Wide numerator) const { return double(numerator) / double(triangle.area); }
  // floor(V + 1/2)
  std::int64_t rounded(Wide numerator) const {
    return static_cast<std::int64_t>(floor_div(2 * numerator + triangle.area, Wide(2) * triangle.area));
  }
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_PLANE_HPP_
