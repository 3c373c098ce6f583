// SPDX-License-Identifier: Apache-2.0
// The motion buffer of the reference: for each pixel of a frame between two keys the face that it shows, and where in
// either key the same point of that face is. Triangles go through the renderer's own snapping and rasterizer.
#ifndef HALFSPACE_REF_MOTION_MOTION_FIELD_HPP_
#define HALFSPACE_REF_MOTION_MOTION_FIELD_HPP_

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ref/geometry/snap.hpp"
#include "ref/motion/motion.hpp"

namespace halfspace::ref {

enum class VectorMapping {
  kLinear,       // by planes of the vectors over the snapped triangle
  kPerspective,  // the point of the face that the pixel's centre shows, projected at the key; straight triangles are
                 // linear in any case
};

// width · height pixels, row 0 on top. Vectors lead from a pixel's centre to a place in key 0 and key 1; the background
// has none, nor has a point that is nearer than the near plane at that key.
template <class Vector>
struct MotionFieldOf {
  int width, height;
  std::vector<std::uint32_t> triangle;  // of the frame, from 1 on; 0: background
  std::vector<std::uint32_t> face;      // of the scene; 0 likewise
  OfKeys<std::vector<std::optional<Vector>>> to_key;
};
using MotionField = MotionFieldOf<glm::dvec2>;
using FixedMotionField = MotionFieldOf<FixedVector>;

MotionField motion_field(const Between&, const RasterFormat&, VectorMapping);

// Exact planes of the fixed vectors of the vertices, rounded half up to the same format.
FixedMotionField motion_field(const Between&, const RasterFormat&, const VectorFormat&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_MOTION_FIELD_HPP_
