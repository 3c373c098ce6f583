// SPDX-License-Identifier: Apache-2.0
#include "ref/raster/ideal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ref/error.hpp"
#include "ref/geometry/plane.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::ref {
namespace {

constexpr std::int64_t kOne = std::int64_t(1) << kIdealSubpixelBits;  // a pixel

constexpr Wide centre(std::int64_t pixel) { return Wide(pixel) * kOne + kOne / 2; }

struct Span {
  std::int64_t first, last;  // pixels, both included
};

// Positions are 62 bits wide, so differences fit in 63, products in 125, and an edge function in 126.
struct IdealTriangle {
  std::array<Wide, 3> x, y;
  std::array<const Vertex*, 3> vertex;
  bool empty;

  explicit IdealTriangle(const std::array<Vertex, 3>& t) : vertex{&t[0], &t[1], &t[2]} {
    for (int v = 0; v < 3; ++v) {
      x[v] = std::int64_t(snapped_position(t[v].x, kIdealSubpixelBits));
      y[v] = std::int64_t(snapped_position(t[v].y, kIdealSubpixelBits));
    }
    const Wide area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    empty = area == 0;
    if (area >= 0) return;
    std::swap(x[1], x[2]), std::swap(y[1], y[2]), std::swap(vertex[1], vertex[2]);
  }

  // Of the vertices as they came.
  std::array<double, 3> as_given(const std::array<double, 3>& weights) const {
    return vertex[1] < vertex[2] ? weights : std::array<double, 3>{weights[0], weights[2], weights[1]};
  }

  // Twice the area of vertex i, the next one and a point: the weight of the third vertex there, not negative inside.
  Wide weight(int i, Wide px, Wide py) const {
    const int j = (i + 1) % 3;
    return (x[j] - x[i]) * (py - y[i]) - (y[j] - y[i]) * (px - x[i]);
  }
  bool top_left(int i) const {
    const int j = (i + 1) % 3;
    return y[j] < y[i] || (y[j] == y[i] && x[j] > x[i]);
  }

  // The pixels of row `py` among `span` that edge i leaves: e + step * (pixel - first) >= 0.
  Span narrow(int i, Span span, std::int64_t row) const {
    const Wide e = weight(i, centre(span.first), centre(row)) - (top_left(i) ? 0 : 1);
    const Wide step = (y[i] - y[(i + 1) % 3]) * kOne;
    if (step == 0) return e >= 0 ? span : Span{0, -1};
    const Wide pixels = floor_div(e, step < 0 ? -step : step);  // to go, or −pixels that are missing
    if (step < 0) return {span.first, pixels < 0 ? -1 : std::min(span.last, std::int64_t(span.first + pixels))};
    return {pixels >= 0 ? span.first : std::int64_t(std::min<Wide>(span.first - pixels, Wide(span.last) + 1)),
            span.last};
  }
};

// Calls visit(column, weights) for a span of a row; the weights of the vertices sum up to 1.
template <class Visit>
void along(const IdealTriangle& t, std::int64_t row, Span span, Visit visit) {
  std::array<Wide, 3> weight, step;
  for (int i = 0; i < 3; ++i) {
    weight[(i + 2) % 3] = t.weight(i, centre(span.first), centre(row));
    step[(i + 2) % 3] = (t.y[i] - t.y[(i + 1) % 3]) * kOne;
  }
  const double area = double(weight[0] + weight[1] + weight[2]);
  for (std::int64_t column = span.first; column <= span.last; ++column) {
    visit(column, std::array<double, 3>{double(weight[0]) / area, double(weight[1]) / area, double(weight[2]) / area});
    for (int i = 0; i < 3; ++i) weight[i] += step[i];
  }
}

double mean(const std::array<double, 3>& weights, const IdealTriangle& t, double Vertex::*value) {
  return weights[0] * t.vertex[0]->*value + weights[1] * t.vertex[1]->*value + weights[2] * t.vertex[2]->*value;
}

// The pixels of a row (column) of `size` whose centres lie in [low, high].
Span pixels_between(Wide low, Wide high, int size) {
  const Wide first = -floor_div<Wide>(centre(0) - low, kOne), last = floor_div<Wide>(high - centre(0), kOne);
  return {std::int64_t(std::max<Wide>(first, 0)), std::int64_t(std::min<Wide>(last, size - 1))};
}

void check(const TriangleList& list) {
  const double limit = std::ldexp(1, kIdealRangeBits - 1);
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    for (const Vertex& v : list.triangles[k]) {
      if (std::abs(v.x) < limit && std::abs(v.y) < limit) continue;
      throw Error(
          fmt::format("triangle {}: a vertex at ({}, {}) is beyond the {} pixels that the ideal picture reaches; "
                      "clip the triangle",
                      k + 1, v.x, v.y, limit));
    }
  }
}

}  // namespace

std::uint32_t face_of(const TriangleList& list, std::uint32_t index) {
  return index == 0 || list.face.empty() ? index : list.face[index - 1];
}

IdealFrame ideal(const TriangleList& list, const IdealShade& shade) {
  check(list);
  const std::int64_t width = list.width;
  const std::size_t pixels = std::size_t(width) * list.height;
  IdealFrame frame{list.width, list.height, std::vector<std::uint32_t>(pixels, 0), std::vector<double>(pixels, 1),
                   std::vector<std::array<double, 3>>(pixels, list.background)};
  std::vector<std::uint32_t>& index = frame.face;  // the number of the triangle at first
  for (std::uint32_t k = 1; k <= list.triangles.size(); ++k) {
    const IdealTriangle t(list.triangles[k - 1]);
    if (t.empty) continue;
    const auto [x_min, x_max] = std::minmax_element(t.x.begin(), t.x.end());
    const auto [y_min, y_max] = std::minmax_element(t.y.begin(), t.y.end());
    const Span columns = pixels_between(*x_min, *x_max, list.width), rows = pixels_between(*y_min, *y_max, list.height);
    for (std::int64_t row = rows.first; row <= rows.last; ++row) {
      Span span = columns;
      for (int i = 0; i < 3 && span.first <= span.last; ++i) span = t.narrow(i, span, row);
      if (span.first > span.last) continue;
      along(t, row, span, [&](std::int64_t column, const std::array<double, 3>& weights) {
        const std::size_t at = std::size_t(row * width + column);
        const double depth = mean(weights, t, &Vertex::z);
        if (depth >= frame.depth[at]) return;
        frame.depth[at] = depth;
        index[at] = k;
      });
    }
  }
  for (std::int64_t row = 0; row < list.height; ++row) {
    for (std::int64_t first = 0, last; first < width; first = last + 1) {
      const std::uint32_t k = index[std::size_t(row * width + first)];
      for (last = first; last + 1 < width && index[std::size_t(row * width + last + 1)] == k; ++last) {}
      if (k == 0) continue;
      const IdealTriangle t(list.triangles[k - 1]);
      along(t, row, {first, last}, [&](std::int64_t column, const std::array<double, 3>& weights) {
        const std::size_t at = std::size_t(row * width + column);
        frame.colour[at] = shade ? shade(k, t.as_given(weights))
                                 : std::array<double, 3>{mean(weights, t, &Vertex::r), mean(weights, t, &Vertex::g),
                                                         mean(weights, t, &Vertex::b)};
        index[at] = face_of(list, k);
      });
    }
  }
  return frame;
}

}  // namespace halfspace::ref
