// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds_triangles.hpp"

#include <algorithm>

namespace halfspace::model {

using ref::SnappedTriangle;

const char* class_name(TriangleClass kind) {
  switch (kind) {
    case TriangleClass::kSmall: return "small";
    case TriangleClass::kAny: return "any";
    case TriangleClass::kHuge: return "across the guard band";
    case TriangleClass::kFrameSliver: return "sliver across the frame";
    case TriangleClass::kGuardBandSliver: return "sliver across the guard band";
    case TriangleClass::kCorner: return "from a corner of the guard band";
  }
  return "";
}

// Not std::uniform_int_distribution: what it draws is not the same everywhere.
std::int64_t TriangleSource::in(std::int64_t low, std::int64_t high) {
  return low + std::int64_t(random_() % std::uint64_t(high - low + 1));
}

std::int32_t TriangleSource::clamped(std::int64_t position) const {
  const std::int64_t limit = std::int64_t(1) << (config_.range_bits + config_.subpixel_bits - 1);
  return std::int32_t(std::clamp(position, -limit, limit - 1));
}

// One in two is an end of the range.
std::uint32_t TriangleSource::any_value(int bits) {
  if (bits == 0) return 0;
  const std::uint32_t full = ref::full_depth(bits);
  return in(0, 1) ? std::uint32_t(in(0, 1)) * full : std::uint32_t(in(0, full));
}

SnappedTriangle TriangleSource::next(TriangleClass kind) {
  SnappedTriangle t{};
  const std::int64_t one = std::int64_t(1) << config_.subpixel_bits, limit = one << (config_.range_bits - 1);
  const std::int64_t w = config_.width * one, h = config_.height * one;
  const std::int64_t cx = in(0, w), cy = in(0, h);
  auto place = [&](int v, std::int64_t x, std::int64_t y) { t.x[v] = clamped(x), t.y[v] = clamped(y); };
  for (int v = 0; v < 3; ++v) {
    const std::int64_t spread = kind == TriangleClass::kSmall ? 8 * one : 60 * one;
    const bool is_everywhere = kind == TriangleClass::kHuge || kind == TriangleClass::kGuardBandSliver;
    if (kind == TriangleClass::kFrameSliver) place(v, in(0, w), in(0, h));
    else if (is_everywhere) place(v, in(-limit, limit), in(-limit, limit));
    else place(v, cx + in(-spread, spread), cy + in(-spread, spread));
    t.depth[v] = any_value(config_.depth_bits);
    for (auto& value : t.rgb[v]) value = std::uint8_t(any_value(config_.colour_bits));
  }
  if (kind == TriangleClass::kFrameSliver || kind == TriangleClass::kGuardBandSliver) {
    place(1, t.x[0] + in(-3, 3), t.y[0] + in(-3, 3));
  }
  if (kind == TriangleClass::kCorner) {
    place(0, in(0, 1) ? -limit : limit, in(0, 1) ? -limit : limit);
    place(1, cx, cy);
    place(2, cx + in(-2, 2), cy + in(-2, 2));
  }
  return t;
}

SnappedTriangle TriangleSource::farthest(Vertices vertices) {
  SnappedTriangle t{};
  const std::int64_t one = std::int64_t(1) << config_.subpixel_bits;
  const std::int64_t first = vertices == Vertices::kFrame ? 0 : -(one << (config_.range_bits - 1));
  const std::int64_t x = config_.width * one - one / 2, y = config_.height * one - one / 2;  // the last centre
  const std::int64_t width = one / 2;
  t.x = {std::int32_t(first), std::int32_t(x - in(0, width)), std::int32_t(x + in(0, width))};
  t.y = {std::int32_t(first), std::int32_t(y + in(0, width)), std::int32_t(y - in(0, width))};
  const bool rising = in(0, 1) != 0;
  if (has_depth(config_)) t.depth[rising ? 1 : 0] = ref::full_depth(config_.depth_bits);
  t.depth[2] = t.depth[1];
  for (int c = 0; c < 3; ++c) {
    t.rgb[rising ? 1 : 0][c] = std::uint8_t(ref::full_depth(config_.colour_bits));
    t.rgb[2][c] = t.rgb[1][c];
  }
  return t;
}

SnappedTriangle TriangleSource::changed(const SnappedTriangle& in_t, Vertices vertices) {
  SnappedTriangle t = in_t;
  const std::int64_t one = std::int64_t(1) << config_.subpixel_bits;
  const std::int64_t first = vertices == Vertices::kFrame ? 0 : -(one << (config_.range_bits - 1));
  const std::int64_t last_x = vertices == Vertices::kFrame ? config_.width * one : -first - 1;
  const std::int64_t last_y = vertices == Vertices::kFrame ? config_.height * one : -first - 1;
  const int v = int(in(0, 2));
  const std::int64_t by = in(0, 1) ? in(-3, 3) : in(-one, one);
  switch (in(0, 3)) {
    case 0: t.x[v] = std::int32_t(std::clamp(t.x[v] + by, first, last_x)); break;
    case 1: t.y[v] = std::int32_t(std::clamp(t.y[v] + by, first, last_y)); break;
    case 2: {
      const std::int64_t full = has_depth(config_) ? ref::full_depth(config_.depth_bits) : 0;
      t.depth[v] =
          std::uint32_t(std::clamp<std::int64_t>(t.depth[v] + by * std::max<std::int64_t>(1, full >> 16), 0, full));
      break;
    }
    default: {
      const std::int64_t full = ref::full_depth(config_.colour_bits);
      for (auto& value : t.rgb[v]) value = std::uint8_t(std::clamp<std::int64_t>(value + in(-2, 2), 0, full));
    }
  }
  return t;
}

}  // namespace halfspace::model
