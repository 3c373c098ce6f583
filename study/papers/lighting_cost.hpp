// SPDX-License-Identifier: Apache-2.0
// What deferred lighting saves a processor: the cost model of the dual pipeline, and the time that our geometry stage
// takes.
#ifndef HALFSPACE_STUDY_PAPERS_LIGHTING_COST_HPP_
#define HALFSPACE_STUDY_PAPERS_LIGHTING_COST_HPP_

#include <cstdint>

#include "ref/geometry/geometry.hpp"

namespace halfspace::model {

// An addition costs 1, a multiplication 2, a reciprocal square root 16.
struct Operations {
  int multiplications, additions, reciprocal_roots;
  constexpr std::uint64_t cost() const {
    return 2 * std::uint64_t(multiplications) + std::uint64_t(additions) + 16 * std::uint64_t(reciprocal_roots);
  }
};
constexpr Operations kViewing{12, 9, 0}, kPerspective{5, 1, 0},
    kLighting{34, 19, 3};  // of a position or a normal; of a vertex

struct TriangleCounts {
  std::uint64_t a = 0;  // of the model
  std::uint64_t b = 0;  // that face the viewer and reach into the frame
  std::uint64_t c = 0;  // of which a fragment passes the Z-test
};

// Three vertices a triangle. Type I transforms positions and normals, culls, and lights what is left; type II lights
// before it culls. The dual pipeline transforms positions, and then normals, and lights them, of visible triangles
// alone.
constexpr std::uint64_t cost_type_1(const TriangleCounts& n) {
  return 3 * (n.a * (2 * kViewing.cost() + kPerspective.cost()) + n.b * kLighting.cost());
}
constexpr std::uint64_t cost_type_2(const TriangleCounts& n) {
  return 3 * n.a * (2 * kViewing.cost() + kPerspective.cost() + kLighting.cost());
}
constexpr std::uint64_t cost_dual(const TriangleCounts& n) {
  return 3 * (n.a * (kViewing.cost() + kPerspective.cost()) + n.c * (kViewing.cost() + kLighting.cost()));
}

struct LightingCost {
  TriangleCounts triangles;
  // Corners lit, as triangles share them.
  std::uint64_t corners_facing = 0, corners_visible = 0;
  // On one thread of this machine, medians: transforming, clipping and culling; then lighting what faces the viewer, or
  // what is visible.
  double positions_ms = 0, light_facing_ms = 0, light_visible_ms = 0;
};
// `config` gives the grid of positions and the depth.
LightingCost measure_lighting(const ref::Scene&, const std::string& config, int width, int height);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PAPERS_LIGHTING_COST_HPP_
