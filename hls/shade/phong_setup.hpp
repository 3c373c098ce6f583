// SPDX-License-Identifier: Apache-2.0
// The planes of the components of a normal over a triangle, for TdbS. Attributes and normals come in one order, normals
// not for empty ones.
//
// A component goes through plane_setup with 2^p units added, so that it is unsigned as depths and colours are, and so
// are the proofs of its widths and bounds: in bits, its top bit inverted. The shader inverts it again.
//
// Interval of the RTL: that of shade_setup.
#ifndef HALFSPACE_HLS_SHADE_PHONG_SETUP_HPP_
#define HALFSPACE_HLS_SHADE_PHONG_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

// n + 2^p units: the bits of n, the top one inverted.
template <class F>
typename F::NormalChannel::Value offset_component(const typename F::Normal& n) {
  using Value = typename F::NormalChannel::Value;
  return slice<Value>(n, 0) + from_raw<Value>(std::uint64_t(1) << F::Normal::fraction());
}

template <class F>
void offset_components(const typename F::Normal (&given)[3], const VertexOrder& order,
                       typename F::NormalChannel::Value (&offset)[3]) {
  typename F::Normal n[3];
  put_in_order(given, order, n);
Vertices:
  for (int v = 0; v < 3; ++v) {
    HS_UNROLL
    offset[v] = offset_component<F>(n[v]);
  }
}

template <class F>
bool phong_setup(Stream<Attributes<F>>& attributes, Stream<Normals<F>>& normals, Stream<NormalPlanes<F>>& planes) {
  const Attributes<F> in = attributes.read();

  NormalPlanes<F> out{};
  out.last = in.last;
  out.empty = in.empty;
  out.index = in.index;
  if (!is_set(in.empty)) {
    const Normals<F> given = normals.read();
    out.material = given.material;
    const PlaneBase<F> base = frame_base(in);
    const VertexOrder order = vertex_order(in);
    typename F::NormalChannel::Value component[3][3];
    offset_components<F>(given.x, order, component[0]);
    offset_components<F>(given.y, order, component[1]);
    offset_components<F>(given.z, order, component[2]);
    const auto plane = channel_planes<F, typename F::NormalChannel>(base, component);
    put_planes(plane, out.start, out.dx, out.dy);
  }
  planes.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_PHONG_SETUP_HPP_
