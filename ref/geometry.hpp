// SPDX-License-Identifier: Apache-2.0
// The geometry stage: from a scene to the triangles of a frame.
#ifndef HALFSPACE_REF_GEOMETRY_HPP_
#define HALFSPACE_REF_GEOMETRY_HPP_

#include "ref/scene.hpp"
#include "ref/triangle_list.hpp"

namespace halfspace::ref {

struct View {
  int width, height;  // pixels
  int range_bits;     // positions come out inside [-2^(range_bits-1) + 1, 2^(range_bits-1) - 1] pixels
  int subpixel_bits;  // of the raster: culling goes by the sign of the area as snapped
  double shift_x = 0, shift_y = 0;  // pixels that the picture is moved to the right and down, before it is clipped
};

// Transform, Phong lighting at the vertices, clipping, division, viewport, culling. Triangles come in the
// order of instances, meshes and faces, each with the number of its face, which no view changes. Error when none is
// left.
TriangleList project(const Scene&, const View&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_HPP_
