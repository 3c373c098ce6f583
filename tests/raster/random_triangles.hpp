// SPDX-License-Identifier: Apache-2.0
// Triangles at random, in sub-pixels.
#ifndef HALFSPACE_TESTS_RASTER_RANDOM_TRIANGLES_HPP_
#define HALFSPACE_TESTS_RASTER_RANDOM_TRIANGLES_HPP_

#include <random>
#include <utility>
#include <vector>

#include "ref/raster/raster.hpp"

namespace halfspace::ref {

using Random = std::mt19937;
inline int pick(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

inline SnappedTriangle random_triangle(Random& random, int reach, int depth_bits) {
  SnappedTriangle t;
  for (int v = 0; v < 3; ++v) {
    t.x[v] = pick(random, -reach, reach), t.y[v] = pick(random, -reach, reach);
    t.depth[v] = static_cast<std::uint32_t>(random() & full_depth(depth_bits));
    for (auto& channel : t.rgb[v]) channel = static_cast<std::uint8_t>(random());
  }
  if (random() % 3 == 0) {  // a sliver
    t.x[2] = t.x[0] + (t.x[1] - t.x[0]) / 3 + pick(random, -2, 2);
    t.y[2] = t.y[0] + (t.y[1] - t.y[0]) / 3 + pick(random, -2, 2);
  }
  return t;
}

inline SnappedList list_of(const RasterFormat& format, int width, int height, std::vector<SnappedTriangle> triangles) {
  return {format, width, height, {1, 2, 3}, std::move(triangles)};
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_RASTER_RANDOM_TRIANGLES_HPP_
