// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/shade_phong.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void shade_phong_top(int red, int green, int blue, const TopNormalDatabase& database,
                                const TopLightTable& lights, const TopMaterialTable& materials, Port<Scan>& scan,
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
  shade_phong_frame(frame, scan_words, database, lights, materials, pixel_words);
}
