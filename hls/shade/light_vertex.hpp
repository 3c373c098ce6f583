// SPDX-License-Identifier: Apache-2.0
// Lights the vertices of a triangle; of a flat one, the one normal that it has.
//
// Interval of the RTL: a cycle a normal and light.
#ifndef HALFSPACE_HLS_SHADE_LIGHT_VERTEX_HPP_
#define HALFSPACE_HLS_SHADE_LIGHT_VERTEX_HPP_

#include "hls/numbers/turns.hpp"
#include "hls/shade/lighting.hpp"

namespace halfspace {

// One normal after the other, which move up.
template <class F>
Colours<F> lit_colours(const Normals<F>& in, const LightTable<F>& lights, const MaterialTable<F>& materials) {
  Normals<F> next = in;
  Colours<F> out{};
  out.last = in.last;
  out.index = in.index;
LitVertices:
  HS_IN_TURN for (int v = 0; v < (F::kGouraud ? 3 : 1); ++v) {
    const typename F::Normal n[3] = {next.x[0], next.y[0], next.z[0]};
    const Rgb<F> colour = light_normal<F>(n, in.material, lights, materials);
    if (F::kGouraud) {
      move_up(next.x, next.x[0]);
      move_up(next.y, next.y[0]);
      move_up(next.z, next.z[0]);
      move_up(out.r, colour.channel[0]);
      move_up(out.g, colour.channel[1]);
      move_up(out.b, colour.channel[2]);
    } else {
      out.r[0] = colour.channel[0];
      out.g[0] = colour.channel[1];
      out.b[0] = colour.channel[2];
    }
  }
  return out;
}

template <class F>
void light_vertex(Stream<Normals<F>>& normals, const LightTable<F>& lights, const MaterialTable<F>& materials,
                  Stream<Colours<F>>& colours) {
  colours.write(lit_colours<F>(normals.read(), lights, materials));
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_LIGHT_VERTEX_HPP_
