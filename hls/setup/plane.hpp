// SPDX-License-Identifier: Apache-2.0
// The plane of an attribute over a triangle (dual pipeline, Gouraud planes):
//
//   N_A = (v1 − v0)·dy2 − (v2 − v0)·dy1,  N_B = (v2 − v0)·dx1 − (v1 − v0)·dx2,  D = dx1·dy2 − dx2·dy1 > 0
//   A = N_A / D,  B = N_B / D,  v(x, y) = v0 + A·(x − x0) + B·(y − y0)
//
// Both gradients are rounded from the product with the same quantized reciprocal, so its relative error, at most
// 2^−r, is a common factor of v − v0, which at a covered point is less than 2^b. Rounding to g fraction bits adds at
// most 2^−(g+1) a pixel of distance from vertex 0:
//
//   |error| <= 2^(b−r) + (|x − x0| + |y − y0|)·2^−(g+1)  LSB      at every covered pixel centre, of any sliver.
//
// Gradients are not clamped: they wrap. Steps of whole pixels need them modulo 2^b, as the plane is; the start lies a
// multiple of 2^−f pixels from vertex 0 and needs them modulo 2^(b+f).
#ifndef HALFSPACE_HLS_SETUP_PLANE_HPP_
#define HALFSPACE_HLS_SETUP_PLANE_HPP_

#include "hls/formats/records.hpp"
#include "hls/setup/reciprocal.hpp"

namespace halfspace {

// The shape of a triangle, as its planes need it.
template <class F>
struct PlaneBase {
  typename F::Delta dx1, dy1, dx2, dy2;  // vertices 1 and 2 from vertex 0
  AreaReciprocal<F> inverse;             // of D
  typename F::Delta dx, dy;              // where the plane starts, from vertex 0
};

// Of planes that start at the centre of pixel (0, 0) of the frame.
template <class F>
PlaneBase<F> frame_base(const Attributes<F>& in) {
  using Coord = typename F::Coord;
  const Coord centre = from_raw<Coord>(1 << (F::kSubpixelBits - 1));
  PlaneBase<F> base;
  base.dx1 = in.dx1;
  base.dy1 = in.dy1;
  base.dx2 = in.dx2;
  base.dy2 = in.dy2;
  base.inverse.shift = in.shift;
  base.inverse.reciprocal = in.reciprocal;
  base.dx = centre - in.x;
  base.dy = centre - in.y;
  return base;
}

// Which of the vertices as given vertex 0, 1 and 2 are.
struct VertexOrder {
  int vertex[3];
};
template <class F>
VertexOrder vertex_order(const Attributes<F>& in) {
  const int from[5] = {0, 1, 2, 0, 1};
  const int first = int(raw(in.first)), step = raw(in.turned) ? 2 : 1;
  VertexOrder order;
  order.vertex[0] = first;
  order.vertex[1] = from[first + step];
  order.vertex[2] = from[first + 3 - step];
  return order;
}

// Channel: F::DepthChannel, F::ColourChannel, F::NormalChannel or F::CoordinateChannel.
template <class Channel>
struct Plane {
  typename Channel::PlaneValue start;  // ½ included: the integer part of a value is it rounded to nearest, half up
  typename Channel::Gradient dx, dy;
};

// floor(N · R · 2^−n + ½) modulo the width of Gradient. The product has up to 77 bits, so N is cut in two:
// with N = H·2^24 + L and t = L·R + 2^(n−1), the sum N·R + 2^(n−1) is (H·R + floor(t / 2^24))·2^24 + t mod 2^24.
template <class F, class Gradient>
Gradient gradient_product(std::int64_t numerator, const typename F::Reciprocal& reciprocal, int n) {
  constexpr int kCut = 24;
  constexpr std::int64_t kLow = (std::int64_t(1) << kCut) - 1;
  const std::int64_t r = raw(reciprocal);
  const std::int64_t half = n > 0 ? std::int64_t(1) << (n - 1) : 0;
  const std::int64_t low = (numerator & kLow) * r + half;
  const std::int64_t high = (numerator >> kCut) * r + (low >> kCut);
  const std::uint64_t wide =
      std::uint64_t(high) << (n < kCut ? kCut - n : 0) | std::uint64_t((low & kLow) >> (n < kCut ? n : 0));
  return from_raw<Gradient>(n < kCut ? std::int64_t(wide) : high >> (n - kCut));
}

template <class F, class Channel>
Plane<Channel> plane_setup(const PlaneBase<F>& base, const typename Channel::Value& v0,
                           const typename Channel::Value& v1, const typename Channel::Value& v2) {
  using Numerator = typename Channel::Numerator;
  using Start = typename Channel::Start;
  using StartGradient = typename Channel::StartGradient;
  const int g = Channel::PlaneValue::fraction();

  const auto dv1 = v1 - v0;
  const auto dv2 = v2 - v0;
  const Numerator numerator_x = dv1 * base.dy2 - dv2 * base.dy1;
  const Numerator numerator_y = dv2 * base.dx1 - dv1 * base.dx2;
  // A sub-pixel over a sub-pixel squared, times 2^f sub-pixels in a pixel, to g fraction bits of N·R·2^−(r+s).
  const int n = int(raw(base.inverse.shift)) + F::kReciprocalFraction - F::kSubpixelBits - g;

  const StartGradient dx = gradient_product<F, StartGradient>(raw(numerator_x), base.inverse.reciprocal, n);
  const StartGradient dy = gradient_product<F, StartGradient>(raw(numerator_y), base.inverse.reciprocal, n);
  Plane<Channel> plane;
  plane.dx = dx;
  plane.dy = dy;

  // Products modulo the width of Start. Dropping their low f bits at the end changes no rounded value: every later
  // step is a multiple of 2^−g.
  const Start along_x = from_raw<Start>(std::uint64_t(raw(dx)) * std::uint64_t(raw(base.dx)));
  const Start along_y = from_raw<Start>(std::uint64_t(raw(dy)) * std::uint64_t(raw(base.dy)));
  // v0 + ½, the last place of Start being 2^−(f+g).
  const Start first = from_raw<Start>((std::uint64_t(raw(v0)) * 2 + 1) << (Start::fraction() - 1));
  const Start sum_x = first + along_x;
  plane.start = sum_x + along_y;
  return plane;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_PLANE_HPP_
