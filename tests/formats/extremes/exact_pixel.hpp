// SPDX-License-Identifier: Apache-2.0
// A pixel of a triangle, in exact integers: what each vertex counts there; and what a judge tells of a frame.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_EXACT_PIXEL_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_EXACT_PIXEL_HPP_

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ref/geometry/plane.hpp"

namespace halfspace::tests {

class ExactPixel {
 public:
  ExactPixel(const ref::SnappedTriangle& triangle, int x, int y, int subpixel_bits) {
    const ref::OrderedTriangle exact(triangle);
    area_ = exact.area;
    const std::int64_t px = ref::pixel_centre(x, subpixel_bits), py = ref::pixel_centre(y, subpixel_bits);
    for (int i = 0; i < 3; ++i) {
      const int a = (i + 1) % 3, b = (i + 2) % 3;
      weight_[std::size_t(exact.vertex[std::size_t(i)])] =
          (exact.x[b] - exact.x[a]) * (py - exact.y[a]) - (exact.y[b] - exact.y[a]) * (px - exact.x[a]);
    }
    for (int v = 0; v < 3; ++v) {
      distance_ =
          std::max(distance_,
                   std::ldexp(double(std::llabs(px - triangle.x[v]) + std::llabs(py - triangle.y[v])), -subpixel_bits));
    }
  }

  // |dx| + |dy| from a vertex, the farthest: which one the kernels start from is theirs.
  double distance() const { return distance_; }
  double plane(const std::array<int, 3>& of_vertex) const {
    ref::Wide sum = 0;
    for (std::size_t v = 0; v < 3; ++v) sum += ref::Wide(weight_[v]) * of_vertex[v];
    return double((long double)sum / (long double)area_);
  }
  double plane(const std::array<double, 3>& of_vertex) const {
    long double sum = 0;
    for (std::size_t v = 0; v < 3; ++v) sum += (long double)weight_[v] * of_vertex[v];
    return double(sum / (long double)area_);
  }

 private:
  std::array<std::int64_t, 3> weight_{};
  std::int64_t area_ = 0;
  double distance_ = 0;
};

// Of values that are the same at all vertices a plane is exact.
inline bool is_constant(const std::array<int, 3>& of_vertex) {
  return of_vertex[0] == of_vertex[1] && of_vertex[1] == of_vertex[2];
}

// What a frame came to, of all numbers that a bound says something of. Sharp: those that may be two places around the
// exact one at most, and so are compared with it; the others are where it is steep, as at the horizon, or jumps.
struct Measured {
  std::uint64_t judged = 0, sharp = 0, differ = 0, blind = 0;
  double largest = 0;  // difference of a sharp one from the exact one, LSB or pixels

  void see(double difference, bool differs, bool is_sharp = true) {
    ++judged;
    if (!is_sharp) return;
    ++sharp;
    differ += differs;
    largest = std::max(largest, difference);
  }
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_EXACT_PIXEL_HPP_
