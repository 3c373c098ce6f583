// SPDX-License-Identifier: Apache-2.0
// The covered pixels of a triangle, a span a row: a sliver costs rows and not the area of its bounding box.
#ifndef HALFSPACE_REF_RASTER_SPANS_HPP_
#define HALFSPACE_REF_RASTER_SPANS_HPP_

#include <algorithm>

#include "ref/geometry/plane.hpp"

namespace halfspace::ref {

// Columns, or rows, of pixels, both ends included; empty when first > last.
struct Span {
  std::int64_t first, last;
};

class Spans {
 public:
  Spans(int width, int height, int subpixel_bits, Cull cull = Cull::kNone)
      : width_(width), height_(height), subpixel_bits_(subpixel_bits), cull_(cull) {}

  std::int64_t one() const { return std::int64_t(1) << subpixel_bits_; }  // pixel, in units of positions
  std::int64_t centre(std::int64_t pixel) const { return pixel_centre(pixel, subpixel_bits_); }

  // Whether the triangle has area, is not culled, and has a pixel centre of the frame in its box.
  bool has_box(const OrderedTriangle& t) const { return holds_centre(t) && !t.is_culled(cull_); }
  // Whether it would have, and is.
  bool is_dropped(const OrderedTriangle& t) const { return holds_centre(t) && t.is_culled(cull_); }

  // visit(row, span) for each row of the triangle's box in the frame, from the top; spans may be empty.
  template <class Visit>
  void of(const OrderedTriangle& t, Visit&& visit) const {
    if (t.area == 0 || t.is_culled(cull_)) return;
    const Span columns = box(t.x, width_), rows = box(t.y, height_);
    for (std::int64_t row = rows.first; row <= rows.last; ++row) {
      Span span = columns;
      for (int i = 0; i < 3; ++i) {
        const std::int64_t step = (t.y[i] - t.y[(i + 1) % 3]) * one();
        span = narrow(span, t.edge(i, centre(span.first), centre(row)), step);
      }
      visit(row, span);
    }
  }

 private:
  bool holds_centre(const OrderedTriangle& t) const {
    const Span columns = box(t.x, width_), rows = box(t.y, height_);
    return t.area != 0 && columns.first <= columns.last && rows.first <= rows.last;
  }
  // The pixels of a row (column) of `size` whose centres the vertices enclose.
  Span box(const std::array<std::int64_t, 3>& vertices, int size) const {
    const auto [low, high] = std::minmax_element(vertices.begin(), vertices.end());
    const std::int64_t first = -floor_div(centre(0) - *low, one());
    const std::int64_t last = floor_div(*high - centre(0), one());
    return {std::max<std::int64_t>(first, 0), std::min<std::int64_t>(last, size - 1)};
  }

  // The pixels of a span whose centres have e + step * (pixel - span.first) >= 0. An empty span stays near the
  // frame, so that edge functions taken at it do not overflow.
  static Span narrow(Span span, std::int64_t e, std::int64_t step) {
    if (step > 0)
      return {std::min(span.first + std::max<std::int64_t>(0, -floor_div(e, step)), span.last + 1), span.last};
    if (step < 0) return {span.first, std::max(std::min(span.last, span.first + floor_div(e, -step)), span.first - 1)};
    return e >= 0 ? span : Span{span.first, span.first - 1};
  }

  const int width_, height_, subpixel_bits_;
  const Cull cull_;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_RASTER_SPANS_HPP_
