// SPDX-License-Identifier: Apache-2.0
// From a point of the scene to a point of the frame. Whoever follows points over time takes the same steps as the
// geometry stage, so that both have the same bits.
#ifndef HALFSPACE_REF_GEOMETRY_PROJECTION_HPP_
#define HALFSPACE_REF_GEOMETRY_PROJECTION_HPP_

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "ref/geometry/clip.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/geometry/viewpoint.hpp"

namespace halfspace::ref {

struct View {
  int width, height;                // pixels
  int range_bits;                   // positions come out inside [-2^(range_bits-1) + 1, 2^(range_bits-1) - 1] pixels
  int subpixel_bits;                // of the raster: culling goes by the sign of the area as snapped
  double shift_x = 0, shift_y = 0;  // pixels that the picture is moved to the right and down, before it is clipped
  bool culls = true;                // faces that are seen from behind are left out; else the rasterizer may drop them
};

// A frame for a rasterizer of that format: whoever of both is said to culls.
View frame_view(const RasterFormat&, int width, int height);

// Of a mesh that is placed by `to_world`.
glm::dvec4 clip_position(const Viewpoint&, const View&, const glm::dmat4& to_world, const glm::dvec3& position);

// Near, far, and the sides of the frame: a triangle outside one of them is not drawn.
std::vector<ClipPlane> frame_planes(const View&);
// Near, far, and the sides of the range, to which triangles are clipped.
std::vector<ClipPlane> guard_planes(const View&);

// Division and viewport; w > 0. Black.
Vertex viewport(const glm::dvec4& clip, const View&);

// Whether it is seen from the front, as snapped: what is kept is what the rasterizer sees.
bool faces_viewer(const std::array<Vertex, 3>&, const View&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_PROJECTION_HPP_
