// SPDX-License-Identifier: Apache-2.0
// The planes of the components of a normal over a triangle, for TdbS. Attributes and normals come in one order, normals
// not for empty ones.
//
// A component goes through plane_setup with 2^p units added, so that it is unsigned as depths and colours are, and so
// are the proofs of its widths and bounds: in bits, its top bit inverted. The shader inverts it again. Interval of the
// RTL: that of shade_setup.
#ifndef HALFSPACE_HLS_SHADE_PHONG_SETUP_HPP_
#define HALFSPACE_HLS_SHADE_PHONG_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

template <class F>
typename F::NormalChannel::Value offset_component(const typename F::Normal& n) {
  return from_raw<typename F::NormalChannel::Value>(raw(n) + (std::int64_t(1) << F::Normal::fraction()));
}

template <class F>
bool phong_setup(Stream<Attributes<F>>& attributes, Stream<Normals<F>>& normals, Stream<NormalPlanes<F>>& planes) {
  const Attributes<F> in = attributes.read();

  NormalPlanes<F> out{};
  out.last = in.last;
  out.empty = in.empty;
  out.index = in.index;
  if (!raw(in.empty)) {
    const Normals<F> given = normals.read();
    out.material = given.material;
    const PlaneBase<F> base = frame_base(in);
    const VertexOrder order = vertex_order(in);
    const typename F::Normal* const component[3] = {given.x, given.y, given.z};
  Components:
    for (int i = 0; i < 3; ++i) {
      const auto plane = plane_setup<F, typename F::NormalChannel>(
          base, offset_component<F>(component[i][order.vertex[0]]), offset_component<F>(component[i][order.vertex[1]]),
          offset_component<F>(component[i][order.vertex[2]]));
      out.start[i] = plane.start;
      out.dx[i] = plane.dx;
      out.dy[i] = plane.dy;
    }
  }
  planes.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_PHONG_SETUP_HPP_
