// SPDX-License-Identifier: Apache-2.0
// Draws one instance of a scene at a time, and keeps nothing of it: a scene of any number of instances needs the
// memory of the largest mesh. Its triangles are those of Geometry, snapped, and its fragments those of render(), to
// the bit.
#ifndef HALFSPACE_REF_OBJECTS_OBJECT_RASTER_HPP_
#define HALFSPACE_REF_OBJECTS_OBJECT_RASTER_HPP_

#include <cstdint>
#include <vector>

#include "ref/geometry/face_parts.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/objects/object_buffer.hpp"
#include "ref/raster/spans.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// A triangle of an object: its face, from 0 on, and which part of it.
constexpr std::uint32_t triangle_number(std::uint32_t face, int part) {
  return face * kMostParts + std::uint32_t(part);
}
constexpr std::uint32_t face_of(std::uint32_t triangle) { return triangle / kMostParts; }
constexpr int part_of(std::uint32_t triangle) { return int(triangle % kMostParts); }

// What an object took.
struct Drawn {
  Box box;                      // holds every pixel that it covers
  std::uint64_t triangles = 0;  // handed to the rasterizer, those without a pixel centre too
};

// The pixels of the frame whose centres lie in the box of a triangle: it covers no others.
Box pixel_box(const SnappedTriangle&, int subpixel_bits, int width, int height);

class ObjectRaster {
 public:
  // Of `format` positions and depths count. The scene outlives it; its instances may move.
  ObjectRaster(const Scene&, const RasterFormat&, int width, int height);

  const View& view() const { return view_; }
  const Viewpoint& viewpoint() const { return viewpoint_; }
  void look_from(const Viewpoint& viewpoint) { viewpoint_ = viewpoint; }

  // each(triangle, number), without colours, in order.
  template <class Each>
  void triangles(std::uint32_t number, Each&& each);
  // visit(x, y, depth, number) for the fragments inside `region`.
  template <class Visit>
  Drawn fragments(std::uint32_t instance, const Box& region, Visit&& visit);

  // Instance n is object n + 1.
  Drawn draw(std::uint32_t instance, ObjectBuffer&, const Box& region);
  // The occlusion query by drawing: fragments that have the key of their pixel. Of an object that is in the buffer, 0
  // when none of its pixels is seen; it is the count of them where no two of its triangles meet in a pixel at one
  // depth.
  std::uint64_t count_equal(std::uint32_t instance, const ObjectBuffer&);

 private:
  struct Corner {
    glm::dvec4 clip;
    unsigned outside_frame, outside_guard;  // bit p: of plane p
    std::int32_t x, y;
    std::uint32_t depth;
  };
  void transform(const Instance&, const Mesh&);
  Corner corner(const glm::dvec4& clip) const;
  void snap_into(SnappedTriangle&, int vertex, const Vertex&) const;
  // Spans of a triangle that is a few pixels wide: each centre of its box is looked at, which takes no division.
  static constexpr int kFewColumns = 3;
  template <class Visit>
  void few_columns(const OrderedTriangle& t, const Box& box, Visit&& visit) const {
    for (int row = box.y0; row < box.y1; ++row) {
      Span span{box.x1, -1};
      for (int column = box.x0; column < box.x1; ++column) {
        const std::int64_t x = spans_.centre(column), y = spans_.centre(row);
        if (t.edge(0, x, y) < 0 || t.edge(1, x, y) < 0 || t.edge(2, x, y) < 0) continue;
        span.first = std::min<std::int64_t>(span.first, column), span.last = column;
      }
      if (span.first <= span.last) visit(row, span);
    }
  }

  const Scene& scene_;
  const View view_;
  const int depth_bits_;
  Viewpoint viewpoint_;
  std::vector<ClipPlane> frame_planes_, guard_planes_;
  const bool frame_in_guard_;
  const Spans spans_;
  std::vector<Corner> corners_;  // of the mesh at hand
};

template <class Each>
void ObjectRaster::triangles(std::uint32_t number, Each&& each) {
  const Instance& instance = scene_.instances[number];
  const Mesh& mesh = scene_.meshes[instance.mesh];
  const bool two_sided = scene_.materials[mesh.material].two_sided;
  const bool mirrored = glm::determinant(glm::dmat3(instance.to_world)) < 0;
  transform(instance, mesh);
  SnappedTriangle t{};
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    std::array<std::uint32_t, 3> at = mesh.triangles[face];
    if (mirrored) std::swap(at[1], at[2]);
    const Corner* const of[3] = {&corners_[at[0]], &corners_[at[1]], &corners_[at[2]]};
    if (of[0]->outside_frame & of[1]->outside_frame & of[2]->outside_frame) continue;
    if (!(of[0]->outside_guard | of[1]->outside_guard | of[2]->outside_guard)) {
      for (int v = 0; v < 3; ++v) t.x[v] = of[v]->x, t.y[v] = of[v]->y, t.depth[v] = of[v]->depth;
      const std::int64_t area = (std::int64_t(t.x[1]) - t.x[0]) * (std::int64_t(t.y[2]) - t.y[0]) -
                                (std::int64_t(t.y[1]) - t.y[0]) * (std::int64_t(t.x[2]) - t.x[0]);
      if (two_sided || area < 0) each(t, triangle_number(face, 0));
      continue;
    }
    std::vector<ClipVertex> polygon{{of[0]->clip, {1, 0, 0}}, {of[1]->clip, {0, 1, 0}}, {of[2]->clip, {0, 0, 1}}};
    face_parts(clip(std::move(polygon), guard_planes_), two_sided, view_, [&](const FacePart& part) {
      for (int v = 0; v < 3; ++v) snap_into(t, v, part.triangle[v]);
      each(t, triangle_number(face, part.number));
    });
  }
}

template <class Visit>
Drawn ObjectRaster::fragments(std::uint32_t instance, const Box& region, Visit&& visit) {
  Drawn drawn;
  triangles(instance, [&](const SnappedTriangle& snapped, std::uint32_t number) {
    ++drawn.triangles;
    const Box box = pixel_box(snapped, view_.subpixel_bits, view_.width, view_.height);
    if (box.empty()) return;
    drawn.box.add(box);
    if (!box.meets(region)) return;
    const OrderedTriangle t(snapped);
    const Plane depth(t, {snapped.depth[0], snapped.depth[1], snapped.depth[2]});
    const auto span_of = [&](std::int64_t row, Span span) {
      Wide numerator = depth.numerator(spans_.centre(span.first), spans_.centre(row));
      const Wide step = Wide(depth.step_x) * spans_.one();
      for (std::int64_t column = span.first; column <= span.last; ++column, numerator += step)
        visit(int(column), int(row), std::uint32_t(depth.rounded(numerator)), number);
    };
    const Box inside = box.cut(region);
    if (box.x1 - box.x0 <= kFewColumns) {
      if (t.area != 0) few_columns(t, inside, span_of);
      return;
    }
    spans_.of(t, [&](std::int64_t row, Span span) {
      if (row < inside.y0 || row >= inside.y1) return;
      span = {std::max<std::int64_t>(span.first, inside.x0), std::min<std::int64_t>(span.last, inside.x1 - 1)};
      if (span.first <= span.last) span_of(row, span);
    });
  });
  return drawn;
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_OBJECTS_OBJECT_RASTER_HPP_
