// SPDX-License-Identifier: Apache-2.0
// Frames of Phong shading: what KernelEngine::light takes beside a snapped list, the normals and the material of each triangle.
#ifndef HALFSPACE_VECTORS_PHONG_HPP_
#define HALFSPACE_VECTORS_PHONG_HPP_

#include <cstdint>

#include "ref/geometry.hpp"
#include "vectors/lighting.hpp"

namespace halfspace::vectors {

// Of the triangles of a geometry. Throws ref::Error where quantized_lighting does.
LightingFrame phong_lighting(const ref::Geometry& geometry, const Config& config);

// For `triangles` triangles, from `seed`: lights and materials of one of lighting_frames(), and normals of all kinds in turn: its
// own, opposite ones, which interpolate to zero, ones at either end of the range, and ones that hardly differ.
LightingFrame awkward_normals(std::size_t triangles, const Config& config, std::uint64_t seed);

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_PHONG_HPP_
