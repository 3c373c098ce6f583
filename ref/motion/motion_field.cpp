// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/motion_field.hpp"

#include "ref/geometry/plane.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::ref {
namespace {

using Weights = std::array<double, 3>;

// Who is where, without vectors. `visit(k, triangle, x, y, at)` for each pixel of triangle k, from 1 on.
template <class Vector, class Visit>
MotionFieldOf<Vector> field_of(const Between& between, const RasterFormat& format, Visit&& visit) {
  const SnappedList list = snap(between.list, format);
  Frame frame = render(list);
  MotionFieldOf<Vector> field{
      list.width, list.height, std::move(frame.index), std::vector<std::uint32_t>(frame.depth.size(), 0), {}};
  for (auto& vectors : field.to_key) vectors.resize(field.face.size());
  for (std::size_t at = 0; at < field.face.size(); ++at) {
    const std::uint32_t k = field.triangle[at];
    if (k == 0) continue;
    field.face[at] = between.traces[k - 1].face;
    visit(field, k, list.triangles[k - 1], static_cast<int>(at % list.width), static_cast<int>(at / list.width), at);
  }
  return field;
}

// Of the vertices before they were snapped, at a pixel's centre; none where snapping has given a sliver its area, and
// the centre is so far outside that nothing could be made of it.
std::optional<Weights> unsnapped_weights(const std::array<Vertex, 3>& t, int x, int y) {
  std::array<glm::dvec2, 3> from;
  for (int v = 0; v < 3; ++v) from[v] = glm::dvec2(t[v].x - (x + 0.5), t[v].y - (y + 0.5));
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const double area = cross(from[1] - from[0], from[2] - from[0]);
  Weights weights;
  for (int v = 0; v < 3; ++v) {
    weights[v] = cross(from[(v + 1) % 3], from[(v + 2) % 3]) / area;
    if (!(weights[v] >= -1 && weights[v] <= 2)) return std::nullopt;
  }
  return weights;
}

// Screen weights as weights in space.
std::optional<Weights> in_space(const Weights& screen, const std::array<double, 3>& w) {
  double sum = 0;
  Weights weights;
  for (int v = 0; v < 3; ++v) sum += weights[v] = screen[v] / w[v];
  if (!(sum > 0)) return std::nullopt;
  for (double& weight : weights) weight /= sum;
  return weights;
}

class Vectors {
 public:
  Vectors(const Between& between, const RasterFormat& format, VectorMapping mapping)
      : between_(between),
        subpixel_bits_(format.subpixel_bits),
        mapping_(mapping),
        view_{between.list.width, between.list.height, 0, 0} {}

  void operator()(MotionField& field, std::uint32_t k, const SnappedTriangle& snapped, int x, int y,
                  std::size_t at) const {
    const OrderedTriangle t(snapped);
    const Weights screen = vertex_weights(t, pixel_centre(x, subpixel_bits_), pixel_centre(y, subpixel_bits_));
    const Trace& trace = between_.traces[k - 1];
    if (mapping_ == VectorMapping::kLinear || trace.straight) {
      const auto of_vertices = vectors(between_, k - 1);
      for (int key = 0; key < kKeys; ++key) {
        if (!of_vertices[key]) continue;
        glm::dvec2 vector(0);
        for (int v = 0; v < 3; ++v) vector += screen[v] * (*of_vertices[key])[v];
        field.to_key[key][at] = vector;
      }
      return;
    }
    std::optional<Weights> weights = unsnapped_weights(between_.list.triangles[k - 1], x, y);
    if (weights) weights = in_space(*weights, trace.w);
    if (!weights) weights = in_space(screen, trace.w);
    for (int key = 0; key < kKeys; ++key) {
      glm::dvec4 point(0);
      for (int v = 0; v < 3; ++v) point += (*weights)[v] * trace.at_key[key][v];
      if (!before_viewer(point)) continue;
      const Vertex place = viewport(point, view_);
      field.to_key[key][at] = glm::dvec2(place.x - (x + 0.5), place.y - (y + 0.5));
    }
  }

 private:
  const Between& between_;
  const int subpixel_bits_;
  const VectorMapping mapping_;
  const View view_;  // its size alone counts
};

}  // namespace

MotionField motion_field(const Between& between, const RasterFormat& format, VectorMapping mapping) {
  return field_of<glm::dvec2>(between, format, Vectors(between, format, mapping));
}

FixedMotionField motion_field(const Between& between, const RasterFormat& format, const VectorFormat& vector_format) {
  const auto visit = [&](FixedMotionField& field, std::uint32_t k, const SnappedTriangle& snapped, int x, int y,
                         std::size_t at) {
    const OrderedTriangle t(snapped);
    const auto of_vertices = fixed_vectors(between, k - 1, format.subpixel_bits, vector_format);
    for (int key = 0; key < kKeys; ++key) {
      if (!of_vertices[key]) continue;
      FixedVector vector;
      for (int axis = 0; axis < 2; ++axis) {
        const auto& corners = *of_vertices[key];
        const Plane plane(t, {corners[0][axis], corners[1][axis], corners[2][axis]});
        const Wide numerator =
            plane.numerator(pixel_centre(x, format.subpixel_bits), pixel_centre(y, format.subpixel_bits));
        vector[axis] = static_cast<std::int32_t>(plane.rounded(numerator));
      }
      field.to_key[key][at] = vector;
    }
  };
  return field_of<FixedVector>(between, format, visit);
}

}  // namespace halfspace::ref
