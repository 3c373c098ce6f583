// SPDX-License-Identifier: Apache-2.0
// What goes with the triangles of a frame, as no scene has it: normals, texture coordinates, places in key frames.
#ifndef HALFSPACE_VECTORS_FRAMES_AWKWARD_HPP_
#define HALFSPACE_VECTORS_FRAMES_AWKWARD_HPP_

#include <cstdint>
#include <vector>

#include "model/pipeline/named_frame.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// For `triangles` triangles, from `seed`: lights and materials of one of lighting_frames(), and normals of all kinds in
// turn: its own, opposite ones, which interpolate to zero, ones at either end of the range, and ones that hardly
// differ.
LightingFrame awkward_normals(std::size_t triangles, const Config& config, std::uint64_t seed);

// For `triangles` triangles, from `seed`: small textures and large ones, longer one way and the other, of noise; and
// coordinates of all kinds in turn: any, ones at either end of the range, ones that hardly differ, w that differ by as
// much as can be, many repetitions, and none of a texture.
TextureFrame awkward_coordinates(std::size_t triangles, const Config& config, std::uint64_t seed);

// For the triangles of a frame, from `seed`, as no scene has them: places of all kinds in turn: near the triangle and
// far from it, at the ends of the range of positions, q as far apart as can be, hardly apart, in any octave, a triangle
// that is nowhere; differences likewise.
MotionFrame awkward_motion(const ref::SnappedList& list, const Config& config, std::uint64_t seed);

// Frames that show the normals of lighting_frames(), one small triangle for three of them.
std::vector<NamedFrame> normal_frames(const ref::RasterFormat& format, const Config& config, std::uint64_t seed);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_AWKWARD_HPP_
