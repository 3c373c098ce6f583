// SPDX-License-Identifier: Apache-2.0
// What Engine::light takes beside a snapped list: the normals and the material of each triangle.
#ifndef HALFSPACE_MODEL_SHADE_FRAME_LIGHTING_HPP_
#define HALFSPACE_MODEL_SHADE_FRAME_LIGHTING_HPP_

#include <cstdint>

#include "model/shade/lighting.hpp"
#include "ref/geometry/geometry.hpp"

namespace halfspace::model {

// Of the triangles of a geometry. Throws ref::Error where quantized_lighting does.
LightingFrame frame_lighting(const ref::Geometry& geometry, const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_SHADE_FRAME_LIGHTING_HPP_
