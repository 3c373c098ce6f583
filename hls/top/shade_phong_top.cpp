// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/shade_phong.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void shade_phong_top(int red, int green, int blue,
                                MemoryWord<NormalPlanes> database[NormalDatabase<TopFormats>::kWords],
                                MemoryWord<Light> lights[LightTable<TopFormats>::kWords],
                                MemoryWord<Material> materials[MaterialTable<TopFormats>::kWords], Port<Scan>& scan,
                                Port<Pixel>& pixel) {
  HS_REGISTER_PORT(red)
  HS_REGISTER_PORT(green)
  HS_REGISTER_PORT(blue)
  HS_MEMORY_PORT(database)
  HS_MEMORY_PORT(lights)
  HS_MEMORY_PORT(materials)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kPhong, "shade_phong is of Phong shading");
  const Frame<TopFormats> frame = background_frame(red, green, blue);
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
  NormalDatabase<F> database_view = {Words<NormalPlanes<F>>(database)};
  LightTable<F> lights_view = {Words<Light<F>>(lights)};
  MaterialTable<F> materials_view = {WordRows<Material<F>, kMostLights>(materials)};
  shade_phong_frame(frame, scan_words, database_view, lights_view, materials_view, pixel_words);
}
