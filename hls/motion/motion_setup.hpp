// SPDX-License-Identifier: Apache-2.0
// The planes of a triangle's places in the key frames, for TdbS: of each key s and t, with perspective q, and with
// F::kRelights three of colour differences. Places and differences are channels as depths and colours are, unsigned,
// and so their planes have the widths and the bounds of those. Attributes and words of motion come in one order, motion
// not for empty ones.
//
// Interval of the RTL: that of shade_setup, affine without F::kRelights two thirds of it, as the keys, and places and
// differences, go side by side.
#ifndef HALFSPACE_HLS_MOTION_MOTION_SETUP_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

// The planes of one key after the other.
template <class F>
HS_SHARED void place_planes(const PlaneBase<F>& base, const VertexOrder& order, const KeyPlaces<F>& given,
                            KeyPlanes<F>& out) {
  typename F::Coordinate place[3][3];
  put_in_order(given.s, order, place[0]);
  put_in_order(given.t, order, place[1]);
  put_in_order(given.q, order, place[2]);
  const auto places = channel_planes<F, typename F::CoordinateChannel>(base, place, F::kPerspective ? 3 : 2);
  put_planes(places, out.start, out.dx, out.dy);
}
template <class F>
HS_SHARED void difference_planes(const PlaneBase<F>& base, const VertexOrder& order, const KeyPlaces<F>& given,
                                 KeyPlanes<F>& out) {
  typename F::Difference difference[3][3];
  put_in_order(given.r, order, difference[0]);
  put_in_order(given.g, order, difference[1]);
  put_in_order(given.b, order, difference[2]);
  const auto differences = channel_planes<F, typename F::DifferenceChannel>(base, difference);
  put_planes(differences, out.colour, out.colour_dx, out.colour_dy);
}
template <class F>
KeyPlanes<F> key_planes(const PlaneBase<F>& base, const VertexOrder& order, const KeyPlaces<F>& given) {
  KeyPlanes<F> out{};
  out.there = given.there;
  out.origin_x = given.origin_x;
  out.origin_y = given.origin_y;
  out.extent = given.extent;
  place_planes(base, order, given, out);
  if (F::kRelights) difference_planes(base, order, given, out);
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
  SetupKeys:
    for (int k = 0; k < kKeys; ++k) out.key[k] = key_planes<F>(base, order, given.key[k]);
  }
  planes.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_SETUP_HPP_
