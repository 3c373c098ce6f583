// SPDX-License-Identifier: Apache-2.0
// Of a configuration with lighting: HALFSPACE_TOP_CONFIG names it.
#include "hls/shade/light_vertex.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void light_vertex_top(const std::int64_t normals[kNormalsFields], const LightTable<TopFormats>* lights,
                                 const MaterialTable<TopFormats>* materials, std::int64_t colours[kColoursFields]) {
  using F = TopFormats;
  static_assert(F::kHasLighting, "light_vertex is of configurations with lighting");
  Stream<Normals<F>> in;
  Stream<Colours<F>> out;
  in.write(read_fields<Normals<F>>(normals));
  light_vertex(in, *lights, *materials, out);
  write_fields(out.read(), colours);
}
