// SPDX-License-Identifier: Apache-2.0
// The planes of a triangle's places in the key frames, for TdbS: of each key s and t, with perspective q, and with
// F::kRelights three of colour differences. Places and differences are channels as depths and colours are, unsigned,
// and so their planes have the widths and the bounds of those. Attributes and words of motion come in one order, motion
// not for empty ones.
// Interval of the RTL: that of two planes, with perspective or F::kRelights that of three, as the keys, and places and
// differences, go side by side.
#ifndef HALFSPACE_HLS_MOTION_MOTION_SETUP_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

template <class F>
KeyPlanes<F> key_planes(const PlaneBase<F>& base, const VertexOrder& order, const KeyPlaces<F>& given) {
  KeyPlanes<F> out{};
  out.there = given.there;
  out.origin_x = given.origin_x;
  out.origin_y = given.origin_y;
  out.extent = given.extent;
  typename F::Coordinate place[3][3];
PlaceVertices:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    place[0][i] = given.s[order.vertex[i]];
    place[1][i] = given.t[order.vertex[i]];
    place[2][i] = given.q[order.vertex[i]];
  }
Places:
  for (int i = 0; i < (F::kPerspective ? 3 : 2); ++i) {
    const auto plane = plane_setup<F, typename F::CoordinateChannel>(base, place[i][0], place[i][1], place[i][2]);
    out.start[i] = plane.start;
    out.dx[i] = plane.dx;
    out.dy[i] = plane.dy;
  }
  if (!F::kRelights) return out;
  typename F::Difference difference[3][3];
DifferenceVertices:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    difference[0][i] = given.r[order.vertex[i]];
    difference[1][i] = given.g[order.vertex[i]];
    difference[2][i] = given.b[order.vertex[i]];
  }
Differences:
  for (int i = 0; i < 3; ++i) {
    const auto plane =
        plane_setup<F, typename F::DifferenceChannel>(base, difference[i][0], difference[i][1], difference[i][2]);
    out.colour[i] = plane.start;
    out.colour_dx[i] = plane.dx;
    out.colour_dy[i] = plane.dy;
  }
  return out;
}

template <class F>
bool motion_setup(Stream<Attributes<F>>& attributes, Stream<MotionVectors<F>>& vectors,
                  Stream<MotionPlanes<F>>& planes) {
  const Attributes<F> in = attributes.read();

  MotionPlanes<F> out{};
  out.last = in.last;
  out.empty = in.empty;
  out.index = in.index;
  if (!is_set(in.empty)) {
    const MotionVectors<F> given = vectors.read();
    out.face = given.face;
    const PlaneBase<F> base = frame_base(in);
    const VertexOrder order = vertex_order(in);
  Keys:
    for (int k = 0; k < kKeys; ++k) out.key[k] = key_planes<F>(base, order, given.key[k]);
  }
  planes.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_SETUP_HPP_
