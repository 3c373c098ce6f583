// SPDX-License-Identifier: Apache-2.0
// The frames that every vector set can begin with: corner cases, each with its reason, the numerical extremes
// (vectors/frames/extremes.hpp) among them, then random triangles.
#ifndef HALFSPACE_VECTORS_STANDARD_SET_HPP_
#define HALFSPACE_VECTORS_STANDARD_SET_HPP_

#include <cstdint>
#include <vector>

#include "vectors/vector_set.hpp"

namespace halfspace::model {

std::vector<NamedFrame> corner_frames(const ref::RasterFormat& format);

// `count` frames of `triangles` triangles each, of mixed kinds and sizes, from `seed`.
std::vector<NamedFrame> random_frames(const ref::RasterFormat& format, std::uint64_t seed, int count, int triangles);

// Gives each frame that has none normals, texture coordinates and motion of all kinds, of what the configuration has.
void add_awkward(const Configuration& configuration, std::uint64_t seed, std::vector<NamedFrame>& frames);

// Corner cases, `random` frames of `triangles` triangles each, what the configuration has besides, and then `frames`;
// each with all that goes with its triangles.
std::vector<NamedFrame> standard_frames(const Configuration& configuration, std::uint64_t seed, int random,
                                        int triangles, std::vector<NamedFrame> frames = {});

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_STANDARD_SET_HPP_
