// SPDX-License-Identifier: Apache-2.0
// Normals that lighting finds hard, for the frames of vector sets.
#ifndef HALFSPACE_VECTORS_AWKWARD_NORMALS_HPP_
#define HALFSPACE_VECTORS_AWKWARD_NORMALS_HPP_

#include <cstdint>
#include <vector>

#include "model/pipeline/named_frame.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// For `triangles` triangles, from `seed`: lights and materials of one of lighting_frames(), and normals of all kinds in
// turn: its own, opposite ones, which interpolate to zero, ones at either end of the range, and ones that hardly
// differ.
LightingFrame awkward_normals(std::size_t triangles, const Config& config, std::uint64_t seed);

// Frames that show the normals of lighting_frames(), one small triangle for three of them.
std::vector<NamedFrame> normal_frames(const ref::RasterFormat& format, const Config& config, std::uint64_t seed);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_AWKWARD_NORMALS_HPP_
