// SPDX-License-Identifier: Apache-2.0
// What deferred lighting saves a processor: the cost model of the dual pipeline, and the time that our geometry stage
// takes.
#ifndef HALFSPACE_STUDY_PAPERS_LIGHTING_COST_HPP_
#define HALFSPACE_STUDY_PAPERS_LIGHTING_COST_HPP_

#include <cstdint>
#include <string>
#include <utility>

#include "ref/geometry/geometry.hpp"

namespace halfspace::model {

// What a processor carries out: an addition costs 1, a multiplication 2, a reciprocal square root 16.
struct Operations {
  std::uint64_t multiplications, additions, reciprocal_roots;
  constexpr std::uint64_t cost() const { return 2 * multiplications + additions + 16 * reciprocal_roots; }
};
constexpr Operations operator+(const Operations& a, const Operations& b) {
  return {a.multiplications + b.multiplications, a.additions + b.additions, a.reciprocal_roots + b.reciprocal_roots};
}
constexpr Operations operator*(std::uint64_t n, const Operations& o) {
  return {n * o.multiplications, n * o.additions, n * o.reciprocal_roots};
}
constexpr Operations kViewing{12, 9, 0}, kPerspective{5, 1, 0},
    kLighting{34, 19, 3};  // of a position or a normal; of a vertex

struct TriangleCounts {
  std::uint64_t a = 0;  // of the model
  std::uint64_t b = 0;  // that face the viewer and reach into the frame
  std::uint64_t c = 0;  // that are visible
};

// Three vertices a triangle. Type I transforms positions and normals, culls, and lights what is left; type II lights
// before it culls. The dual pipeline transforms positions, and then normals, and lights them, of visible triangles
// alone.
constexpr Operations type_1(const TriangleCounts& n) {
  return 3 * n.a * (2 * kViewing + kPerspective) + 3 * n.b * kLighting;
}
constexpr Operations type_2(const TriangleCounts& n) { return 3 * n.a * (2 * kViewing + kPerspective + kLighting); }
constexpr Operations dual(const TriangleCounts& n) {
  return 3 * n.a * (kViewing + kPerspective) + 3 * n.c * (kViewing + kLighting);
}

// Percentages as printed, the first two of whole ones, the others to a tenth.
struct PrintedShares {
  double c_of_b, c_of_a, dual_of_type_1, dual_of_type_2;
};
// The numbers of visible triangles, first and last, that give all of them; {1, 0} if none does.
std::pair<std::uint64_t, std::uint64_t> visible_of(std::uint64_t a, std::uint64_t b, const PrintedShares&);

struct LightingCost {
  TriangleCounts passed;  // c: of which a fragment passed the Z-test when they were drawn
  TriangleCounts seen;    // c: that a pixel of the finished picture shows
  // Corners lit, as triangles share them; the visible ones are those of `passed`.
  std::uint64_t corners_facing = 0, corners_visible = 0;
  // On one thread of this machine, medians: transforming, clipping and culling; then lighting what faces the viewer, or
  // what passed.
  double positions_ms = 0, light_facing_ms = 0, light_visible_ms = 0;
};
// `config` gives the grid of positions and the depth.
LightingCost measure_lighting(const ref::Scene&, const std::string& config, int width, int height);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PAPERS_LIGHTING_COST_HPP_
