// SPDX-License-Identifier: Apache-2.0
#include "ref/objects/object_raster.hpp"

#include <algorithm>
#include <cmath>

#include "ref/error.hpp"

namespace halfspace::ref {
namespace {

unsigned outside(const glm::dvec4& clip, const std::vector<ClipPlane>& planes) {
  unsigned bits = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) bits |= unsigned(!(glm::dot(planes[p], clip) >= 0)) << p;
  return bits;
}

}  // namespace

Box pixel_box(const SnappedTriangle& t, int subpixel_bits, int width, int height) {
  const int f = subpixel_bits, half = 1 << (f - 1);
  const auto [x0, x1] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [y0, y1] = std::minmax({t.y[0], t.y[1], t.y[2]});
  return Box{(x0 + half - 1) >> f, (y0 + half - 1) >> f, ((x1 - half) >> f) + 1, ((y1 - half) >> f) + 1}.cut(
      {0, 0, width, height});
}

ObjectRaster::ObjectRaster(const Scene& scene, const RasterFormat& format, int width, int height)
    : scene_(scene),
      view_{width, height, format.range_bits, format.subpixel_bits},
      depth_bits_(format.depth_bits),
      viewpoint_(ref::viewpoint(scene, double(width) / height)),
      frame_planes_(frame_planes(view_)),
      guard_planes_(guard_planes(view_)),
      frame_in_guard_(std::max(width, height) < 1 << (format.range_bits - 1)),
      spans_(width, height, format.subpixel_bits) {
  if (depth_bits_ == 0)
    throw Error("format " + format.name + " has no depth, by which buffers are merged: take one that has");
}

void ObjectRaster::snap_into(SnappedTriangle& t, int v, const Vertex& vertex) const {
  t.x[v] = std::int32_t(snapped_position(vertex.x, view_.subpixel_bits));
  t.y[v] = std::int32_t(snapped_position(vertex.y, view_.subpixel_bits));
  t.depth[v] = std::uint32_t(std::round(vertex.z * full_depth(depth_bits_)));
}

ObjectRaster::Corner ObjectRaster::corner(const glm::dvec4& clip) const {
  Corner corner{clip, 0, 0, 0, 0, 0};
  // Well inside the frame it is inside all planes, whatever the rounding.
  const double w = (1 - 1e-6) * clip.w;
  if (!(clip.z > 0 && clip.z < w && std::abs(clip.x) < w && std::abs(clip.y) < w && frame_in_guard_)) {
    corner.outside_frame = outside(clip, frame_planes_);
    corner.outside_guard = outside(clip, guard_planes_);
  }
  if (corner.outside_guard == 0) {
    SnappedTriangle t;
    snap_into(t, 0, viewport(clip, view_));
    corner.x = t.x[0], corner.y = t.y[0], corner.depth = t.depth[0];
  }
  return corner;
}

void ObjectRaster::transform(const Instance& instance, const Mesh& mesh) {
  corners_.clear();
  for (const glm::dvec3& position : mesh.positions)
    corners_.push_back(corner(clip_position(viewpoint_, view_, instance.to_world, position)));
}

Drawn ObjectRaster::draw(std::uint32_t instance, ObjectBuffer& buffer, const Box& region) {
  return fragments(instance, region, [&](int x, int y, std::uint32_t depth, std::uint32_t triangle) {
    buffer.test(x, y, object_key(depth, instance + 1), triangle);
  });
}

std::uint64_t ObjectRaster::count_equal(std::uint32_t instance, const ObjectBuffer& buffer) {
  std::uint64_t count = 0;
  fragments(instance, buffer.frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t) {
    count += buffer.at(x, y).key == object_key(depth, instance + 1);
  });
  return count;
}

}  // namespace halfspace::ref
