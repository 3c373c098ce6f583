// SPDX-License-Identifier: Apache-2.0
// The colour planes of a triangle, for TdbS. The reciprocal is the one of the triangle setup. A flat colour goes
// through. Colours come with the attributes or, with F::kHasLighting, from light_vertex, in one order, and not for
// empty ones.
//
// Interval of the RTL: 24 cycles a triangle in low, 30 in middle and high; 3 if it is empty, 1 if flat.
#ifndef HALFSPACE_HLS_SETUP_SHADE_SETUP_HPP_
#define HALFSPACE_HLS_SETUP_SHADE_SETUP_HPP_

#include "hls/setup/plane.hpp"

namespace halfspace {

// The colours of `in`, in the order of its vertices, are r, g, b.
template <class F>
Planes<F> colour_planes(const Attributes<F>& in, const typename F::Colour (&r)[3], const typename F::Colour (&g)[3],
                        const typename F::Colour (&b)[3]) {
  Planes<F> out{};
  out.last = in.last;
  out.empty = in.empty;
  out.index = in.index;
  if (!F::kGouraud) {
    out.r = r[0];
    out.g = g[0];
    out.b = b[0];
  } else if (!is_set(in.empty)) {
    const PlaneBase<F> base = frame_base(in);
    const typename F::Colour value[3][3] = {{r[0], r[1], r[2]}, {g[0], g[1], g[2]}, {b[0], b[1], b[2]}};
    const auto planes = channel_planes<F, typename F::ColourChannel>(base, value);
    out.r = planes.of[0].start;
    out.r_dx = planes.of[0].dx;
    out.r_dy = planes.of[0].dy;
    out.g = planes.of[1].start;
    out.g_dx = planes.of[1].dx;
    out.g_dy = planes.of[1].dy;
    out.b = planes.of[2].start;
    out.b_dx = planes.of[2].dx;
    out.b_dy = planes.of[2].dy;
  }
  return out;
}

template <class F>
bool shade_setup(Stream<Attributes<F>>& attributes, Stream<Planes<F>>& planes) {
  const Attributes<F> in = attributes.read();
  planes.write(colour_planes<F>(in, in.r, in.g, in.b));
  return is_set(in.last);
}

template <class F>
bool shade_setup(Stream<Attributes<F>>& attributes, Stream<Colours<F>>& colours, Stream<Planes<F>>& planes) {
  const Attributes<F> in = attributes.read();
  Colours<F> ordered{};
  if (!is_set(in.empty)) {
    const Colours<F> given = colours.read();
    // Flat: of the one colour.
    if (F::kGouraud) {
      const VertexOrder order = vertex_order(in);
      put_in_order(given.r, order, ordered.r);
      put_in_order(given.g, order, ordered.g);
      put_in_order(given.b, order, ordered.b);
    } else {
      ordered = given;
    }
  }
  planes.write(colour_planes<F>(in, ordered.r, ordered.g, ordered.b));
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SETUP_SHADE_SETUP_HPP_
