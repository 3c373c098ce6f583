// SPDX-License-Identifier: Apache-2.0
// The colour planes of a triangle, for TdbS. The reciprocal is the one of the triangle setup. A flat colour goes through.
// Interval of the RTL: 24 cycles in low, 30 in middle and high; 3 for an empty record, 1 if flat.
#ifndef HALFSPACE_HLS_SHADE_SETUP_HPP_
#define HALFSPACE_HLS_SHADE_SETUP_HPP_

#include "plane.hpp"

namespace halfspace {

template <class F>
void shade_setup(Stream<Attributes<F>>& attributes, Stream<Planes<F>>& planes) {
  using Channel = typename F::ColourChannel;
  const Attributes<F> in = attributes.read();

  Planes<F> out{};
  out.last = in.last;
  out.empty = in.empty;
  out.index = in.index;
  if (!F::kGouraud) {
    out.r = in.r[0];
    out.g = in.g[0];
    out.b = in.b[0];
  } else if (!raw(in.empty)) {
    const PlaneBase<F> base = frame_base(in);
    const auto r = plane_setup<F, Channel>(base, in.r[0], in.r[1], in.r[2]);
    const auto g = plane_setup<F, Channel>(base, in.g[0], in.g[1], in.g[2]);
    const auto b = plane_setup<F, Channel>(base, in.b[0], in.b[1], in.b[2]);
    out.r = r.start;
    out.r_dx = r.dx;
    out.r_dy = r.dy;
    out.g = g.start;
    out.g_dx = g.dx;
    out.g_dy = g.dy;
    out.b = b.start;
    out.b_dx = b.dx;
    out.b_dy = b.dy;
  }
  planes.write(out);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SETUP_HPP_
