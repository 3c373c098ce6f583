// SPDX-License-Identifier: Apache-2.0
// The planes of the texture coordinates of a triangle, for TdbS: s and t, and with perspective q. The coordinates are
// channels as depths and colours are, unsigned and of b bits, and so their planes have the widths and the bounds of
// those. Every triangle that has attributes, and is not empty, has a word of coordinates, also one without a texture.
//
// Interval of the RTL: that of shade_setup; affine two thirds of it.
#ifndef HALFSPACE_HLS_TEXTURE_TEXTURE_SETUP_HPP_
#define HALFSPACE_HLS_TEXTURE_TEXTURE_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

template <class F>
bool texture_setup(Stream<Attributes<F>>& attributes, Stream<TextureCoordinates<F>>& coordinates,
                   Stream<TexturePlanes<F>>& planes) {
  const Attributes<F> in = attributes.read();

  TexturePlanes<F> out{};
  out.last = in.last;
  out.empty = in.empty;
  out.index = in.index;
  if (!is_set(in.empty)) {
    const TextureCoordinates<F> given = coordinates.read();
    out.texture = given.texture;
    out.repeats = given.repeats;
    const PlaneBase<F> base = frame_base(in);
    const VertexOrder order = vertex_order(in);
    typename F::Coordinate component[3][3];
    put_in_order(given.s, order, component[0]);
    put_in_order(given.t, order, component[1]);
    put_in_order(given.q, order, component[2]);
    const auto of_coordinates =
        channel_planes<F, typename F::CoordinateChannel>(base, component, F::kPerspective ? 3 : 2);
    put_planes(of_coordinates, out.start, out.dx, out.dy);
  }
  planes.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_TEXTURE_SETUP_HPP_
