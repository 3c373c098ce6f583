// SPDX-License-Identifier: Apache-2.0
// The proved bounds of a configuration, from its numbers alone. docs/bounds.md has the derivations;
// study/proofs/gappa.hpp prints the proofs.
#ifndef HALFSPACE_STUDY_PROOFS_BOUNDS_PROVED_HPP_
#define HALFSPACE_STUDY_PROOFS_BOUNDS_PROVED_HPP_

#include <cstdint>

#include "hls/formats/formats.hpp"

namespace halfspace::model {

// mantissa · 2^exponent.
struct Dyadic {
  std::int64_t mantissa;
  int exponent;
};
double value(const Dyadic& number);
Dyadic operator+(const Dyadic& a, const Dyadic& b);
Dyadic operator*(std::int64_t factor, const Dyadic& number);
// The next that is not less, of 24 bits.
Dyadic dyadic_above(double number);

// What the plane of a channel is made with.
struct PlaneNumbers {
  int value_bits;       // b
  int reciprocal_bits;  // r
  int fraction;         // g
};
PlaneNumbers depth_numbers(const Config& config);
PlaneNumbers colour_numbers(const Config& config);
// Of a component of a normal, in units of 2^−p.
PlaneNumbers normal_numbers(const Config& config);
// Of s, t and q: of a texture, or of a place in a key frame.
PlaneNumbers coordinate_numbers(const Config& config);
// Of a colour difference, in units of 2^−kDifferenceFraction LSB.
PlaneNumbers difference_numbers(const Config& config);

// Where the vertices of a triangle may lie.
enum class Vertices { kGuardBand, kFrame };

// The most that |x − x0| + |y − y0| can be, in pixels, from vertex 0 to a covered pixel centre of the largest frame.
Dyadic largest_reach(const Config& config, Vertices vertices);

// Of |R·D·2^−(r+s) − 1|: 2^−r.
Dyadic reciprocal_bound(const Config& config);

// In LSB, at every covered pixel centre of the largest frame. `sum` is v0 + A·(x − x0) + B·(y − y0); a register holds
// it with its ½ and cut to g fraction bits; `rounded` is the integer that leaves the unit.
struct PlaneBound {
  Dyadic sum, in_register, rounded;
};
PlaneBound plane_bound(const PlaneNumbers& numbers, const Dyadic& reach);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_BOUNDS_PROVED_HPP_
