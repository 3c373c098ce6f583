// SPDX-License-Identifier: Apache-2.0
#include "ref/raster/raster.hpp"

#include "ref/raster/spans.hpp"

namespace halfspace::ref {
namespace {

class Raster {
 public:
  explicit Raster(const SnappedList& list)
      : list_(list), spans_(list.width, list.height, list.format.subpixel_bits, list.format.cull) {
    const std::size_t pixels = std::size_t(list.width) * list.height;
    const std::uint32_t full = full_depth(list.format.depth_bits);
    const double scale = 255.0 / full_depth(colour_bits());
    std::array<std::uint8_t, 4> background{0, 0, 0, 255};
    std::array<double, 3> exact_background;
    for (int c = 0; c < 3; ++c) {
      background[c] = displayed_colour(list.background[c], colour_bits());
      exact_background[c] = list.background[c] * scale;
    }
    frame_ = {list.width,
              list.height,
              std::vector<std::uint32_t>(pixels, 0),
              std::vector<std::uint32_t>(pixels, full),
              std::vector<std::array<std::uint8_t, 4>>(pixels, background),
              std::vector<double>(pixels, full),
              std::vector<std::array<double, 3>>(pixels, exact_background),
              std::vector<bool>(list.triangles.size(), false)};
  }

  Frame run() {
    for (std::uint32_t k = 1; k <= list_.triangles.size(); ++k) draw(k);
    for (std::size_t at = 0; at < frame_.index.size();) at = shade_run(at);
    return std::move(frame_);
  }

 private:
  int colour_bits() const { return list_.format.colour_bits; }
  bool has_depth() const { return list_.format.depth_bits != 0; }
  // All 0 without depth.
  Plane depth_plane(const OrderedTriangle& t, const SnappedTriangle& of) const {
    if (!has_depth()) return Plane(t, {0, 0, 0});
    return Plane(t, {of.depth[0], of.depth[1], of.depth[2]});
  }
  std::int64_t centre(std::int64_t pixel) const { return spans_.centre(pixel); }

  void draw(std::uint32_t k) {
    const SnappedTriangle& snapped = list_.triangles[k - 1];
    const OrderedTriangle t(snapped);
    const Plane depth = depth_plane(t, snapped);
    spans_.of(t, [&](std::int64_t row, Span span) { draw_span(k, depth, row, span); });
  }

  void draw_span(std::uint32_t k, const Plane& depth, std::int64_t row, Span span) {
    Wide numerator = depth.numerator(centre(span.first), centre(row));
    const Wide step = Wide(depth.step_x) * spans_.one();
    for (std::int64_t column = span.first; column <= span.last; ++column, numerator += step) {
      const std::size_t at = std::size_t(row) * list_.width + column;
      if (!has_depth()) {
        if (frame_.index[at] != 0) continue;
      } else {
        const std::int64_t fragment = depth.rounded(numerator);
        if (fragment >= std::int64_t(frame_.depth[at])) continue;
        frame_.depth[at] = static_cast<std::uint32_t>(fragment);
      }
      frame_.index[at] = k;
      frame_.visible[k - 1] = true;
    }
  }

  // Scan-out of the pixels from `at` on that have the same index; returns the first beyond them.
  std::size_t shade_run(std::size_t at) {
    const std::uint32_t k = frame_.index[at];
    std::size_t end = at + 1;
    while (end < frame_.index.size() && frame_.index[end] == k) ++end;
    if (k != 0) {
      const SnappedTriangle& snapped = list_.triangles[k - 1];
      const OrderedTriangle t(snapped);
      const Plane depth = depth_plane(t, snapped);
      for (std::size_t i = at; i < end; ++i) frame_.exact_depth[i] = depth.exact(numerator_at(depth, i));
      for (int c = 0; c < 3; ++c) {
        std::array<std::int64_t, 3> of_vertex{snapped.rgb[0][c], snapped.rgb[1][c], snapped.rgb[2][c]};
        if (list_.format.flat) of_vertex.fill(snapped.rgb[0][c]);
        const Plane colour(t, of_vertex);
        for (std::size_t i = at; i < end; ++i) {
          const Wide numerator = numerator_at(colour, i);
          frame_.exact_colour[i][c] = colour.exact(numerator) * (255.0 / full_depth(colour_bits()));
          frame_.colour[i][c] = displayed_colour(static_cast<unsigned>(colour.rounded(numerator)), colour_bits());
        }
      }
    }
    return end;
  }

  Wide numerator_at(const Plane& plane, std::size_t pixel) const {
    return plane.numerator(centre(pixel % list_.width), centre(pixel / list_.width));
  }

  const SnappedList& list_;
  const Spans spans_;
  Frame frame_;
};

}  // namespace

Frame render(const SnappedList& list) { return Raster(list).run(); }

bool covers(const SnappedTriangle& triangle, int subpixel_bits, int px, int py) {
  const OrderedTriangle t(triangle);
  const std::int64_t x = pixel_centre(px, subpixel_bits), y = pixel_centre(py, subpixel_bits);
  return t.area != 0 && t.edge(0, x, y) >= 0 && t.edge(1, x, y) >= 0 && t.edge(2, x, y) >= 0;
}

}  // namespace halfspace::ref
