// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/light_vertex.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void light_vertex_top(MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
                                 MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords],
                                 Port<Normals>& normals, Port<Colours>& colours) {
  HS_MEMORY_PORT(lights)
  HS_MEMORY_PORT(materials)
  HS_STREAM_PORT(normals)
  HS_STREAM_PORT(colours)
  HS_FREE_RUNNING
  using F = TopFormats;
  static_assert(F::kHasLighting && !F::kPhong, "light_vertex is of configurations that light vertices");
  View<Normals> normals_words(normals);
  View<Colours> colours_words(colours);
  LightTable<F> lights_view = {Words<Light<F>>(lights)};
  MaterialTable<F> materials_view = {WordRows<Material<F>, kMostLights>(materials)};
  light_vertex(normals_words, lights_view, materials_view, colours_words);
}
