// SPDX-License-Identifier: Apache-2.0
// A snapped triangle in exact arithmetic: the order of its vertices, coverage, planes. It shares no code with hls/ or
// ref/.
//
// No sum here leaves 128 bits: with |D| < 2^(2c), 2c + 3 <= 64 and b + g + f <= 63 for every accepted configuration,
// the largest is a register of b + g bits times D, below 2^124.
#ifndef HALFSPACE_STUDY_BOUNDS_BOUNDS_EXACT_HPP_
#define HALFSPACE_STUDY_BOUNDS_BOUNDS_EXACT_HPP_

#include <array>
#include <cstdint>
#include <cstdlib>

#include "ref/geometry/snap.hpp"

namespace halfspace::model {

using Wide = __int128;

// A channel's values at the vertices, in the order of ExactTriangle.
using Values = std::array<std::int64_t, 3>;

// Gradients are N/D LSB a unit of position.
struct Numerators {
  Wide x, y;
};

struct PixelSpan {
  int first, last;  // none if first > last
};

class ExactTriangle {
 public:
  // Vertex 0 is the topmost, of these the leftmost; D >= 0.
  ExactTriangle(const ref::SnappedTriangle& triangle, int subpixel_bits);

  Wide area() const { return area_; }  // D
  std::int64_t x(int v) const { return x_[v]; }
  std::int64_t y(int v) const { return y_[v]; }
  const Values& depth() const { return depth_; }
  const Values& colour(int channel) const { return colour_[channel]; }
  // What was given for the vertices in their own order, in this one.
  Values in_order(const std::array<int, 3>& given) const {
    return {given[std::size_t(order_[0])], given[std::size_t(order_[1])], given[std::size_t(order_[2])]};
  }

  // From vertex 0 to the centre of a pixel, in units.
  std::int64_t dx(int px) const { return centre(px) - x_[0]; }
  std::int64_t dy(int py) const { return centre(py) - y_[0]; }

  // Edge i at a pixel centre, the bias of the tie rule included: inside is >= 0 in all three.
  Wide edge(int i, int px, int py) const;
  // The bounding box: pixels of a frame whose centres lie between the vertices.
  PixelSpan columns(int width) const { return between(x_, width); }
  PixelSpan rows(int height) const { return between(y_, height); }
  // The covered pixels of a row of a frame, by division: no edge function is walked.
  PixelSpan span(int py, int width) const;

  Numerators numerators(const Values& v) const;
  // The value of a channel at a pixel centre, times D.
  Wide value(const Values& v, int px, int py) const;
  long double quotient(const Values& v, int px, int py) const {
    return (long double)value(v, px, py) / (long double)area_;
  }
  // |dx| + |dy| of a pixel centre from vertex 0, in pixels.
  double distance(int px, int py) const { return double(std::llabs(dx(px)) + std::llabs(dy(py))) / double(one_); }

 private:
  std::int64_t centre(int pixel) const { return pixel * one_ + one_ / 2; }
  std::int64_t edge_dx(int i) const { return x_[(i + 1) % 3] - x_[i]; }
  std::int64_t edge_dy(int i) const { return y_[(i + 1) % 3] - y_[i]; }
  PixelSpan between(const std::array<std::int64_t, 3>& positions, int size) const;
  bool inclusive(int i) const { return edge_dy(i) < 0 || (edge_dy(i) == 0 && edge_dx(i) > 0); }

  std::int64_t one_;
  std::array<int, 3> order_;  // which of the vertices as given each is
  std::array<std::int64_t, 3> x_, y_;
  Values depth_;
  std::array<Values, 3> colour_;
  Wide area_;
};

// `bits`/2^fraction − value/area, `bits` known modulo 2^(b + fraction): the difference nearest to 0, in LSB.
double register_error(std::uint64_t bits, int b, int fraction, Wide value, Wide area);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_EXACT_HPP_
