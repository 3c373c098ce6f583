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
#include "hls/numbers/arithmetic.hpp"
#include "hls/numbers/turns.hpp"
#include "hls/setup/reciprocal.hpp"

namespace halfspace {

// The shape of a triangle, as its planes need it.
template <class F>
struct PlaneBase {
  typename F::Delta dx1, dy1, dx2, dy2;  // vertices 1 and 2 from vertex 0
  AreaReciprocal<F> inverse;             // of D
  typename F::Delta dx, dy;              // where the plane starts, from vertex 0
};

template <class F>
typename F::Coord half_pixel() {
  return from_raw<typename F::Coord>(1 << (F::kSubpixelBits - 1));
}

// Of planes that start at the centre of pixel (0, 0) of the frame.
template <class F>
PlaneBase<F> frame_base(const Attributes<F>& in) {
  const typename F::Coord centre = half_pixel<F>();
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
  const int first = int(raw(in.first));
  const int next = first == 2 ? 0 : first + 1, other = first == 0 ? 2 : first - 1;
  const bool turned = is_set(in.turned);
  VertexOrder order;
  order.vertex[0] = first;
  order.vertex[1] = turned ? other : next;
  order.vertex[2] = turned ? next : other;
  return order;
}
// What was given for three vertices, in that order: chosen, where an index would be an address.
template <class T>
void put_in_order(const T (&given)[3], const VertexOrder& order, T (&ordered)[3]) {
Vertices:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    const int v = order.vertex[i];
    ordered[i] = select(v == 0, given[0], select(v == 1, given[1], given[2]));
  }
}

// Channel: F::DepthChannel, F::ColourChannel, F::NormalChannel or F::CoordinateChannel.
template <class Channel>
struct Plane {
  typename Channel::PlaneValue start;  // ½ included: the integer part of a value is it rounded to nearest, half up
  typename Channel::Gradient dx, dy;
};

// x and y take turns on two products of a value by a distance, one by R and one of a start.
template <class F, class Channel>
Plane<Channel> plane_setup(const PlaneBase<F>& base, const typename Channel::Value& v0,
                           const typename Channel::Value& v1, const typename Channel::Value& v2) {
  using Start = typename Channel::Start;
  using StartGradient = typename Channel::StartGradient;
  const int g = Channel::PlaneValue::fraction();
  // A sub-pixel over a sub-pixel squared, times 2^f sub-pixels in a pixel, to g fraction bits of N·R·2^−(r+s).
  const int n = int(raw(base.inverse.shift)) + F::kReciprocalFraction - F::kSubpixelBits - g;

  const auto dv1 = v1 - v0;
  const auto dv2 = v2 - v0;
  // v0 + ½. Dropping the low f bits of the sum at the end changes no rounded value: every later step is a multiple of
  // 2^−g.
  Start start = Start(v0) + shift_left(from_raw<Start>(1), Start::fraction() - 1);
  StartGradient dx{}, dy{};
Axes:
  HS_IN_TURN for (int axis = 0; axis < 2; ++axis) {
    const bool y = axis == 1;
    const auto first = select(y, dv2, dv1), second = select(y, dv1, dv2);
    const typename F::Delta of_first = select(y, base.dx1, base.dy2), of_second = select(y, base.dx2, base.dy1);
    const typename Channel::Numerator numerator = first * of_first - second * of_second;
    dx = dy;
    dy = rounded_product<StartGradient>(numerator, base.inverse.reciprocal, n);
    start = start + product_modulo<Start>(dy, select(y, base.dy, base.dx));
  }

  Plane<Channel> plane;
  plane.start = start;
  plane.dx = dx;
  plane.dy = dy;
  return plane;
}

// The planes of the first `count` of three channels, of values[channel][vertex]: they take turns. Channel 0 leaves
// first, and the others move up.
template <class F, class Channel>
struct ChannelPlanes {
  Plane<Channel> of[3];
};
template <class F, class Channel>
ChannelPlanes<F, Channel> channel_planes(const PlaneBase<F>& base, const typename Channel::Value (&values)[3][3],
                                         int count = 3) {
  using Value = typename Channel::Value;
  Value a0 = values[0][0], a1 = values[0][1], a2 = values[0][2];
  Value b0 = values[1][0], b1 = values[1][1], b2 = values[1][2];
  Value c0 = values[2][0], c1 = values[2][1], c2 = values[2][2];
  ChannelPlanes<F, Channel> planes{};
Channels:
  HS_IN_TURN for (int i = 0; i < count; ++i) {
    const Plane<Channel> plane = plane_setup<F, Channel>(base, a0, a1, a2);
    a0 = b0, a1 = b1, a2 = b2;
    b0 = c0, b1 = c1, b2 = c2;
    move_up(planes.of, plane);
  }
  if (count == 2) move_up(planes.of, Plane<Channel>{});
  return planes;
}

// The numbers of three planes into the fields of a record.
template <class F, class Channel>
HS_INLINE inline void put_planes(const ChannelPlanes<F, Channel>& planes, typename Channel::PlaneValue (&start)[3],
                                 typename Channel::Gradient (&dx)[3], typename Channel::Gradient (&dy)[3]) {
Planes:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    start[i] = planes.of[i].start;
    dx[i] = planes.of[i].dx;
    dy[i] = planes.of[i].dy;
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_PLANE_HPP_
