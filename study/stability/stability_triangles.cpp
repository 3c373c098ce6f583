// SPDX-License-Identifier: Apache-2.0
#include "study/stability/stability_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace halfspace::model {
namespace {

struct Vector {
  std::int64_t x, y;
};
double squared(Vector a) { return double(a.x) * double(a.x) + double(a.y) * double(a.y); }

// s·a + t·b = gcd(a, b)
std::int64_t extended_gcd(std::int64_t a, std::int64_t b, std::int64_t& s, std::int64_t& t) {
  if (b == 0) {
    s = a < 0 ? -1 : 1, t = 0;
    return a < 0 ? -a : a;
  }
  std::int64_t s1, t1;
  const std::int64_t gcd = extended_gcd(b, a % b, s1, t1);
  s = t1, t = s1 - a / b * t1;
  return gcd;
}

// The vectors v with cross(u, v) = area, u without a common divisor, lie a multiple of u apart: the one whose
// projection on u is nearest to `at`·u. False if u has a common divisor.
bool nearest_of_area(Vector u, Wide area, double at, Vector& v) {
  std::int64_t s, t;
  if (extended_gcd(u.x, u.y, s, t) != 1) return false;
  // u.x·s + u.y·t = 1: cross(u, (−t, s)) = 1.
  const Wide x = -area * t, y = area * s, dot = x * u.x + y * u.y, square = Wide(u.x) * u.x + Wide(u.y) * u.y;
  const Wide whole = dot / square;
  const Wide n = whole + Wide(std::llround(double(dot - whole * square) / double(square) - at));
  v = {std::int64_t(x - n * u.x), std::int64_t(y - n * u.y)};
  return true;
}

}  // namespace

double squared_length(const ref::SnappedTriangle& t) {
  double longest = 0;
  for (int v = 0; v < 3; ++v) {
    const int to = (v + 1) % 3;
    longest = std::max(longest, squared({std::int64_t(t.x[to]) - t.x[v], std::int64_t(t.y[to]) - t.y[v]}));
  }
  return longest;
}

std::int64_t ShapeSource::in(std::int64_t low, std::int64_t high) {
  return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
}

bool ShapeSource::accept(const ref::SnappedTriangle& t, int px, int py) const {
  const std::int64_t limit = std::int64_t(1) << (config_.range_bits - 1 + config_.subpixel_bits);
  for (int v = 0; v < 3; ++v) {
    if (t.x[v] < -limit || t.x[v] >= limit || t.y[v] < -limit || t.y[v] >= limit) return false;
  }
  const ExactTriangle exact(t, config_.subpixel_bits);
  return exact.area() > 0 && exact.edge(0, px, py) >= 0 && exact.edge(1, px, py) >= 0 && exact.edge(2, px, py) >= 0;
}

// Half of the values at the ends of their range.
void ShapeSource::colour(ref::SnappedTriangle& t) {
  auto any = [&](std::int64_t full) { return in(0, 1) ? full * in(0, 1) : in(0, full); };
  for (int v = 0; v < 3; ++v) {
    t.depth[v] = std::uint32_t(any((std::int64_t(1) << config_.depth_bits) - 1));
    for (auto& channel : t.rgb[v]) channel = std::uint8_t(any((1 << config_.colour_bits) - 1));
  }
}

// From a pixel centre p to two vertices a and b, all but opposite: cross(a, b) = d, the part of D on the far side of p;
// then the third vertex, anywhere along the edge, that makes D.
bool ShapeSource::try_aspect(double length, double aspect, ref::SnappedTriangle& t) {
  const int px = int(in(0, config_.width - 1)), py = int(in(0, config_.height - 1));
  const std::int64_t one = std::int64_t(1) << config_.subpixel_bits;
  const Vector p{px * one + one / 2, py * one + one / 2};
  const std::int64_t area = std::max<std::int64_t>(1, std::llround(length * length / aspect));
  const std::int64_t d = area < 3 ? area : in(1, std::max<std::int64_t>(1, area / 3));
  const double angle = 8 * std::atan(1.0) * uniform(), part = 0.3 + 0.4 * uniform();
  const Vector b{std::llround(length * part * std::cos(angle)), std::llround(length * part * std::sin(angle))};
  Vector a, c;
  // cross(a, b) = d is cross(b, a) = −d.
  if ((b.x == 0 && b.y == 0) || !nearest_of_area(b, -Wide(d), -(1 - part) / part, a)) return false;
  const Vector u{b.x - a.x, b.y - a.y};
  if ((u.x == 0 && u.y == 0) || !nearest_of_area(u, area, uniform(), c)) return false;
  const std::int64_t x[3] = {p.x + a.x, p.x + b.x, p.x + a.x + c.x}, y[3] = {p.y + a.y, p.y + b.y, p.y + a.y + c.y};
  for (int v = 0; v < 3; ++v) {
    if (std::llabs(x[v]) >> 31 || std::llabs(y[v]) >> 31) return false;
    t.x[v] = std::int32_t(x[v]), t.y[v] = std::int32_t(y[v]);
  }
  return accept(t, px, py);
}

std::optional<ref::SnappedTriangle> ShapeSource::of_aspect(int log2) {
  const double one = std::ldexp(1, config_.subpixel_bits), side = std::ldexp(one, config_.range_bits);
  // D >= 1: an edge has to be as long as √aspect.
  const double least = std::max(config_.width * one / 2, std::exp2((log2 - 0.5) / 2));
  const double most = std::min(std::max(config_.width * one, 1.5 * least), std::sqrt(2.0) * side);
  for (int tries = 0; tries < 20000 && least <= most; ++tries) {
    ref::SnappedTriangle t{};
    // An equilateral one has 2/√3.
    const double aspect = std::exp2(log2 + uniform() - 0.5);
    if (!try_aspect(least + (most - least) * uniform(), std::max(aspect, 1.1), t)) continue;
    const double got = std::log2(squared_length(t) / double(ExactTriangle(t, config_.subpixel_bits).area()));
    if (std::fabs(got - log2) > 0.5) continue;
    colour(t);
    return t;
  }
  return std::nullopt;
}

std::optional<ref::SnappedTriangle> ShapeSource::of_size(int log2) {
  const std::int64_t one = std::int64_t(1) << config_.subpixel_bits;
  const std::int64_t limit = (std::int64_t(1) << (config_.range_bits - 1)) * one;
  const std::int64_t side = std::min<std::int64_t>(std::llround(std::ldexp(double(one), log2)), 2 * limit - 1);
  for (int tries = 0; tries < 20000; ++tries) {
    ref::SnappedTriangle t{};
    const int px = int(in(0, config_.width - 1)), py = int(in(0, config_.height - 1));
    auto corner = [&](std::int64_t centre) { return std::clamp(centre - in(0, side), -limit, limit - 1 - side); };
    const std::int64_t left = corner(px * one + one / 2), top = corner(py * one + one / 2);
    // The box is filled: a vertex on each of its sides.
    const std::int64_t x[3] = {left, left + side, left + in(0, side)}, y[3] = {top + in(0, side), top, top + side};
    const int turn = int(in(0, 2));
    for (int v = 0; v < 3; ++v) t.x[v] = std::int32_t(x[v]), t.y[v] = std::int32_t(y[(v + turn) % 3]);
    if (!accept(t, px, py)) continue;
    if (squared_length(t) > 8 * double(ExactTriangle(t, config_.subpixel_bits).area())) continue;
    colour(t);
    return t;
  }
  return std::nullopt;
}

}  // namespace halfspace::model
