// SPDX-License-Identifier: Apache-2.0
// What Engine::light takes beside a snapped list: the normals and the material of each triangle.
#ifndef HALFSPACE_VECTORS_FRAME_LIGHTING_HPP_
#define HALFSPACE_VECTORS_FRAME_LIGHTING_HPP_

#include <cstdint>

#include "ref/geometry.hpp"
#include "vectors/lighting.hpp"
#include "vectors/vector_set.hpp"

namespace halfspace::vectors {

// Of the triangles of a geometry. Throws ref::Error where quantized_lighting does.
LightingFrame frame_lighting(const ref::Geometry& geometry, const Config& config);

// For `triangles` triangles, from `seed`: lights and materials of one of lighting_frames(), and normals of all kinds in turn: its
// own, opposite ones, which interpolate to zero, ones at either end of the range, and ones that hardly differ.
LightingFrame awkward_normals(std::size_t triangles, const Config& config, std::uint64_t seed);

// Frames that show the normals of lighting_frames(), one small triangle for three of them.
std::vector<NamedFrame> normal_frames(const ref::RasterFormat& format, const Config& config, std::uint64_t seed);

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_FRAME_LIGHTING_HPP_
