// SPDX-License-Identifier: Apache-2.0
// Where a pixel lies in a texture or in a key frame, exactly, and how far off the kernels may be there: as
// texture_place_bound and motion_bound have it, but that a plane of one value is exact.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_PLACE_BOUND_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_PLACE_BOUND_HPP_

#include "study/proofs/texture_bounds.hpp"
#include "tests/formats/extremes/exact_pixel.hpp"

namespace halfspace::tests {

struct Place {
  double at, error;  // in units of the span
};

inline Place exact_part(const Config& config, const std::array<int, 3>& s, const std::array<int, 3>& q,
                        const ExactPixel& pixel) {
  const double rounded = 0.5 + model::coordinate_plane_bound(config, pixel.distance());
  const double of_s = is_constant(s) ? 0 : rounded, above = pixel.plane(s);
  if (!has_perspective(config))
    return {std::ldexp(above, -config.coordinate_bits), std::ldexp(of_s, -config.coordinate_bits)};
  const double of_q = is_constant(q) ? 0 : rounded, below = pixel.plane(q), part = above / below;
  // The rounded q is a unit at least.
  const double division = (of_s + part * of_q) / std::max(below - of_q, std::min(below, 1.0));
  return {part, division + (part + division) * model::kInverseError};
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_PLACE_BOUND_HPP_
