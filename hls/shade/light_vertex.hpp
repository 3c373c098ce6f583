// SPDX-License-Identifier: Apache-2.0
// Lights the vertices of a triangle; of a flat one, the one normal that it has.
// Interval of the RTL: a cycle a normal and light.
#ifndef HALFSPACE_HLS_SHADE_LIGHT_VERTEX_HPP_
#define HALFSPACE_HLS_SHADE_LIGHT_VERTEX_HPP_

#include "hls/shade/lighting.hpp"

namespace halfspace {

template <class F>
void light_vertex(Stream<Normals<F>>& normals, const LightTable<F>& lights, const MaterialTable<F>& materials,
                  Stream<Colours<F>>& colours) {
  const Normals<F> in = normals.read();
  Colours<F> out{};
  out.last = in.last;
  out.index = in.index;
Vertices:
  for (int v = 0; v < 3; ++v) {
    if (v > 0 && !F::kGouraud) break;
    const typename F::Normal n[3] = {in.x[v], in.y[v], in.z[v]};
    const Rgb<F> colour = light_normal<F>(n, in.material, lights, materials);
    out.r[v] = colour.channel[0];
    out.g[v] = colour.channel[1];
    out.b[v] = colour.channel[2];
  }
  colours.write(out);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_LIGHT_VERTEX_HPP_
