// SPDX-License-Identifier: Apache-2.0
// A triangle of a micro configuration by integers: what triangle_setup and shade_setup have to make of it.
#ifndef HALFSPACE_TESTS_RASTER_EXACT_TRIANGLE_HPP_
#define HALFSPACE_TESTS_RASTER_EXACT_TRIANGLE_HPP_

#include <array>
#include <cstdint>
#include <utility>

#include "hls/formats/formats.hpp"

namespace halfspace::tests {

struct Micro {
  static constexpr Config config() { return {"micro", 4, 4, 4, 5, 1, 3, 2, 7, 6, 6, 1, Shading::kGouraud}; }
};
constexpr Config kConfig = Micro::config();

// A place, in sub-pixels: half pixels.
struct Place {
  int x, y;
};
constexpr int kGrid = 16, kPlaces = kGrid * kGrid,
              kBefore = 4;  // places each way, those before the frame's first pixel
inline Place place(int n) { return {n % kGrid - kBefore, n / kGrid - kBefore}; }
// Values that are no plane over the grid.
inline int depth_at(int n) { return (n * 5 + n / kGrid * 3 + n * n / 7) & 7; }
inline int colour_at(int n, int channel) { return (n + n / kGrid + n * n / (5 + channel)) >> channel & 3; }

inline std::int64_t modulo(std::int64_t value, int bits) { return value & ((std::int64_t(1) << bits) - 1); }

struct PlaneNumbers {
  std::int64_t start, dx, dy;
};

// A triangle by integers, in the order that its setup has: the topmost place first, of these the leftmost; D > 0.
struct Exact {
  std::array<int, 3> vertex;  // numbers of places
  std::array<Place, 3> at;
  int area;  // D

  explicit Exact(std::array<int, 3> v) : vertex(v) {
    // The number of a place is its order from the top left.
    if (vertex[1] < vertex[0]) std::swap(vertex[0], vertex[1]);
    if (vertex[2] < vertex[0]) std::swap(vertex[0], vertex[2]);
    look();
    if (area < 0) std::swap(vertex[1], vertex[2]), look();
  }
  void look() {
    for (int i = 0; i < 3; ++i) at[i] = place(vertex[i]);
    area = cross(0, at[2]);
  }
  // Of edge i and a place: > 0 inside.
  int cross(int i, Place p) const {
    const Place a = at[i], b = at[(i + 1) % 3];
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  // The edge function, less 1 where a place on the edge is not of the triangle: it is if it comes inside as it moves
  // right by a hair, and down by less than that.
  int edge(int i, Place p) const { return cross(i, p) - !keeps_own(i); }
  bool keeps_own(int i) const {
    const Place a = at[i], b = at[(i + 1) % 3];
    return (b.x - a.x) - 64 * (b.y - a.y) > 0;
  }

  // floor(log2 D), and 2^(r + s)/D, rounded.
  int shift() const {
    int s = 0;
    while (area >> (s + 1)) ++s;
    return s;
  }
  std::int64_t reciprocal() const {
    const std::int64_t one = std::int64_t(1) << (kConfig.reciprocal_bits + shift());
    return (2 * one + area) / (2 * area);
  }
  // Of values at the three vertices, b bits; from `from` on.
  PlaneNumbers plane(std::array<int, 3> value, Place from, int g) const {
    const int f = kConfig.subpixel_bits, n = shift() + kConfig.reciprocal_bits - f - g;
    const std::int64_t dv1 = value[1] - value[0], dv2 = value[2] - value[0];
    const Place a = at[0], b = at[1], c = at[2];
    const auto gradient = [&](std::int64_t numerator) {
      return (2 * numerator * reciprocal() + (std::int64_t(1) << n)) >> (n + 1);
    };
    PlaneNumbers p;
    p.dx = gradient(dv1 * (c.y - a.y) - dv2 * (b.y - a.y));
    p.dy = gradient(dv2 * (b.x - a.x) - dv1 * (c.x - a.x));
    p.start =
        ((2 * value[0] + 1) * (std::int64_t(1) << (g + f - 1)) + p.dx * (from.x - a.x) + p.dy * (from.y - a.y)) >> f;
    return p;
  }
};

constexpr Place centre(int x, int y) { return {2 * x + 1, 2 * y + 1}; }

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_RASTER_EXACT_TRIANGLE_HPP_
