// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds_exact.hpp"

#include <algorithm>

namespace halfspace::model {
namespace {

Wide floor_divide(Wide a, Wide b) {
  const Wide quotient = a / b;
  return quotient - ((a % b != 0) && ((a < 0) != (b < 0)));
}

}  // namespace

ExactTriangle::ExactTriangle(const ref::SnappedTriangle& t, int subpixel_bits)
    : one_(std::int64_t(1) << subpixel_bits) {
  std::array<int, 3>& order = order_;
  order = {0, 1, 2};
  auto before = [&](int a, int b) { return t.y[a] != t.y[b] ? t.y[a] < t.y[b] : t.x[a] < t.x[b]; };
  std::rotate(order.begin(), std::min_element(order.begin(), order.end(), before), order.end());
  auto cross = [&] {
    const std::int64_t x0 = t.x[order[0]], y0 = t.y[order[0]];
    return (t.x[order[1]] - x0) * Wide(t.y[order[2]] - y0) - (t.x[order[2]] - x0) * Wide(t.y[order[1]] - y0);
  };
  if (cross() < 0) std::swap(order[1], order[2]);
  area_ = cross();
  for (int v = 0; v < 3; ++v) {
    x_[v] = t.x[order[v]];
    y_[v] = t.y[order[v]];
    depth_[v] = t.depth[order[v]];
    for (int c = 0; c < 3; ++c) colour_[c][v] = t.rgb[order[v]][c];
  }
}

PixelSpan ExactTriangle::between(const std::array<std::int64_t, 3>& positions, int size) const {
  const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
  const Wide first = -floor_divide(one_ / 2 - *low, one_), last = floor_divide(*high - one_ / 2, one_);
  return {int(std::max<Wide>(first, 0)), int(std::min<Wide>(last, size - 1))};
}

Wide ExactTriangle::edge(int i, int px, int py) const {
  return Wide(edge_dx(i)) * (centre(py) - y_[i]) - Wide(edge_dy(i)) * (centre(px) - x_[i]) - !inclusive(i);
}

// The edge function falls by dy·2^f a pixel: it is >= 0 up to, or from, the floor of its value at pixel 0 over that.
PixelSpan ExactTriangle::span(int py, int width) const {
  PixelSpan span = {0, area_ > 0 ? width - 1 : -1};
  for (int i = 0; i < 3; ++i) {
    const Wide at_0 = edge(i, 0, py), fall = Wide(edge_dy(i)) * one_;
    if (fall > 0) span.last = int(std::min<Wide>(span.last, floor_divide(at_0, fall)));
    if (fall < 0) span.first = int(std::max<Wide>(span.first, -floor_divide(at_0, -fall)));
    if (fall == 0 && at_0 < 0) span.last = -1;
  }
  return span;
}

Numerators ExactTriangle::numerators(const Values& v) const {
  const Wide dv1 = v[1] - v[0], dv2 = v[2] - v[0];
  return {dv1 * (y_[2] - y_[0]) - dv2 * (y_[1] - y_[0]), dv2 * (x_[1] - x_[0]) - dv1 * (x_[2] - x_[0])};
}

Wide ExactTriangle::value(const Values& v, int px, int py) const {
  const Numerators n = numerators(v);
  return v[0] * area_ + n.x * dx(px) + n.y * dy(py);
}

double register_error(std::uint64_t bits, int b, int fraction, Wide value, Wide area) {
  const Wide scale = Wide(1) << fraction, period = (Wide(1) << (b + fraction)) * area;
  Wide error = (Wide(bits) * area - value * scale) % period;
  if (error > period / 2) error -= period;
  if (error < -period / 2) error += period;
  return double(error) / double(area) / double(scale);
}

}  // namespace halfspace::model
