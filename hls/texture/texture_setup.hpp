// SPDX-License-Identifier: Apache-2.0
// The planes of the texture coordinates of a triangle, for TdbS: s and t, and with perspective q. The coordinates are
// channels as depths and colours are, unsigned and of b bits, and so their planes have the widths and the bounds of
// those. Every triangle that has attributes, and is not empty, has a word of coordinates, also one without a texture.
// Interval of the RTL: that of shade_setup with perspective, less a plane without.
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
  Vertices:
    for (int i = 0; i < 3; ++i) {
      HS_UNROLL
      component[0][i] = given.s[order.vertex[i]];
      component[1][i] = given.t[order.vertex[i]];
      component[2][i] = given.q[order.vertex[i]];
    }
  Components:
    for (int i = 0; i < (F::kPerspective ? 3 : 2); ++i) {
      const auto plane =
          plane_setup<F, typename F::CoordinateChannel>(base, component[i][0], component[i][1], component[i][2]);
      out.start[i] = plane.start;
      out.dx[i] = plane.dx;
      out.dy[i] = plane.dy;
    }
  }
  planes.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TEXTURE_TEXTURE_SETUP_HPP_
