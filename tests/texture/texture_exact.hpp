// SPDX-License-Identifier: Apache-2.0
// Where a pixel lies in a texture, exactly, and how far off the kernels may be there.
#ifndef HALFSPACE_TESTS_TEXTURE_TEXTURE_EXACT_HPP_
#define HALFSPACE_TESTS_TEXTURE_TEXTURE_EXACT_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "model/texture/texture.hpp"
#include "ref/geometry/plane.hpp"
#include "study/proofs/texture_bounds.hpp"

namespace halfspace::tests {

struct ExactPlace {
  glm::dvec2 uv;     // in units of the texture's sides
  glm::dvec2 bound;  // of what the kernels cut to texels or to weights, in texels
};

// Of pixel (x, y), covered by a triangle with (u, v) and w at its vertices, for which the kernels got `words`. `sides`:
// of the texture, in texels.
inline ExactPlace exact_place(const Config& config, const ref::SnappedTriangle& triangle,
                              const std::array<glm::dvec2, 3>& uv, const std::array<double, 3>& w,
                              const model::RawCoordinates& words, const glm::dvec2& sides, int x, int y) {
  const std::int64_t px = ref::pixel_centre(x, config.subpixel_bits), py = ref::pixel_centre(y, config.subpixel_bits);
  const std::array<double, 3> weights = ref::vertex_weights(ref::OrderedTriangle(triangle), px, py);
  ExactPlace out{glm::dvec2(0), {}};
  glm::dvec2 st(0), spread(0);
  double q = 0, total = 0, distance = 0;  // from any vertex: which one the kernels start from is theirs
  for (int v = 0; v < 3; ++v) {
    st += weights[v] * glm::dvec2(words.s[v], words.t[v]), q += weights[v] * words.q[v];
    const double weight = has_perspective(config) ? weights[v] / w[v] : weights[v];
    total += weight, out.uv += weight * uv[v];
    distance = std::max(distance, std::ldexp(double(std::abs(px - triangle.x[v]) + std::abs(py - triangle.y[v])),
                                             -config.subpixel_bits));
  }
  out.uv /= total;
  for (int v = 0; v < 3; ++v) spread = glm::max(spread, glm::abs(uv[v] - out.uv));
  if (!has_perspective(config)) q = std::ldexp(1.0, config.coordinate_bits);
  const double least = *std::min_element(words.q.begin(), words.q.end()), repetitions = std::ldexp(1.0, words.repeats);
  for (int i = 0; i < 2; ++i) {
    const double span = sides[i] * repetitions;
    out.bound[i] = model::texture_place_bound(config, span, st[i] / q, q, distance) +
                   model::texture_vertex_bound(config, span, spread[i] / repetitions, q, least) +
                   model::texture_cut_bound(config);
  }
  return out;
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_TEXTURE_TEXTURE_EXACT_HPP_
