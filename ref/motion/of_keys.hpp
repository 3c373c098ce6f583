// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_MOTION_OF_KEYS_HPP_
#define HALFSPACE_REF_MOTION_OF_KEYS_HPP_

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace halfspace::ref {

// The two key times, the earlier one first.
constexpr int kKeys = 2;
template <class T>
using OfKeys = std::array<T, kKeys>;

// Of the vertices of each triangle of a frame: their lit colours there less those of the same points at a key, 0-255,
// as rounded to the colour bits at either, so that the planes of the difference are the difference of the planes. Where
// a texture multiplies what is lit, times its mean: which texel a key shows is not known.
using LightChange = std::vector<std::array<glm::dvec3, 3>>;

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_OF_KEYS_HPP_
