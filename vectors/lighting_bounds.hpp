// SPDX-License-Identifier: Apache-2.0
// How far off the lighting kernels may be, and the exact formula on the integers that they take. docs/numerics.md has the
// derivation.
#ifndef HALFSPACE_VECTORS_LIGHTING_BOUNDS_HPP_
#define HALFSPACE_VECTORS_LIGHTING_BOUNDS_HPP_

#include "vectors/bounds_proved.hpp"
#include "vectors/lighting.hpp"

namespace halfspace::vectors {

// ρ: of |y·√m − 1| of reciprocal_sqrt.
constexpr Dyadic kRootBound = {1, -17};

// δ, of a cosine: ρ + 2^−u·(1 + ρ).
double cosine_bound(const Config& config);
// e_j, of a cosine squared j times: 2^j·δ + (2^j − 1)·2^−(u+1).
double power_bound(const Config& config, int squarings);
// Of the sum in LSB before rounding, one light that is white at full scale, with the largest exponent that is built.
double light_bound(const Config& config);

// A channel of a lit normal, in LSB, and its bound.
struct ExactLight {
  long double value, bound;
};
ExactLight exact_light(const LightingFrame& frame, int material, const std::array<int, 3>& normal, int channel, const Config& config);

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_LIGHTING_BOUNDS_HPP_
