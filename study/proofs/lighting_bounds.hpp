// SPDX-License-Identifier: Apache-2.0
// How far off the lighting kernels may be, by proof and as seen, and the exact formula on the integers that they take.
// docs/numerics.md has the derivation.
#ifndef HALFSPACE_STUDY_PROOFS_LIGHTING_BOUNDS_HPP_
#define HALFSPACE_STUDY_PROOFS_LIGHTING_BOUNDS_HPP_

#include "model/shade/lighting.hpp"
#include "study/proofs/bounds_proved.hpp"

namespace halfspace::model {

// ρ: of |y·√m − 1| of reciprocal_sqrt. lighting_test tries every field.
constexpr Dyadic kRootBound = {1, -17};

// δ, of a cosine: ρ + 2^−u.
Dyadic cosine_bound(const Config& config);
// e_j, of a cosine squared j times: 2·e_(j−1) + 2^−(u+1), e_0 = δ.
Dyadic power_bound(const Config& config, int squarings);
// Of the sum in LSB before rounding, one light that is white at full scale, with the largest exponent that is built.
Dyadic light_bound(const Config& config);

// A channel of a lit normal, in LSB, and the bound of its sum. A normal of length 0 shows its base. Its components are
// in any unit.
struct ExactLight {
  long double value, bound;
};
using RealNormal = std::array<long double, 3>;
ExactLight exact_light(const LightingFrame& frame, int material, const RealNormal& normal, int channel,
                       const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_LIGHTING_BOUNDS_HPP_
