// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/projection.hpp"

#include <algorithm>
#include <cmath>

#include "ref/geometry/plane.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::ref {
namespace {

// Near and far, then the sides of a rectangle in pixels. Near comes first: behind it w > 0, and a side only
// means what it should there.
std::vector<ClipPlane> planes_around(const View& view, double left, double right, double top, double bottom) {
  const double w = view.width / 2.0, h = view.height / 2.0;  // pixel = (w + w x/w_clip, h - h y/w_clip)
  return {{0, 0, 1, 0},          {0, 0, -1, 1},       {w, 0, 0, w - left},
          {-w, 0, 0, right - w}, {0, -h, 0, h - top}, {0, h, 0, bottom - h}};
}

}  // namespace

View frame_view(const RasterFormat& format, int width, int height) {
  View view{width, height, format.range_bits, format.subpixel_bits};
  view.culls = format.cull == Cull::kNone;
  return view;
}

glm::dvec4 clip_position(const Viewpoint& viewpoint, const View& view, const glm::dmat4& to_world,
                         const glm::dvec3& position) {
  glm::dvec4 clip = viewpoint.to_clip * (to_world * glm::dvec4(position, 1));
  clip.x += 2 * view.shift_x / view.width * clip.w;
  clip.y -= 2 * view.shift_y / view.height * clip.w;
  return clip;
}

std::vector<ClipPlane> frame_planes(const View& view) { return planes_around(view, 0, view.width, 0, view.height); }

// One pixel inside the range, so that neither rounding nor snapping leads out of it.
std::vector<ClipPlane> guard_planes(const View& view) {
  const double guard = std::ldexp(1.0, view.range_bits - 1) - 1;
  return planes_around(view, -guard, guard, -guard, guard);
}

Vertex viewport(const glm::dvec4& clip, const View& view) {
  const glm::dvec3 p = glm::dvec3(clip) / clip.w;
  return {view.width * (0.5 + 0.5 * p.x), view.height * (0.5 - 0.5 * p.y), std::clamp(p.z, 0.0, 1.0), 0, 0, 0};
}

// Counter-clockwise on the screen, which is a negative area as rows go downward.
bool faces_viewer(const std::array<Vertex, 3>& t, const View& view) {
  std::array<Wide, 3> x, y;
  for (int i = 0; i < 3; ++i) {
    x[i] = std::int64_t(snapped_position(t[i].x, view.subpixel_bits));
    y[i] = std::int64_t(snapped_position(t[i].y, view.subpixel_bits));
  }
  return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]) < 0;
}

}  // namespace halfspace::ref
