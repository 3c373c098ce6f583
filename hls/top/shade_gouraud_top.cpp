// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/shade_gouraud.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void shade_gouraud_top(int red, int green, int blue,
                                  MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Scan>& scan,
                                  Port<Pixel>& pixel) {
  HS_REGISTER_PORT(red)
  HS_REGISTER_PORT(green)
  HS_REGISTER_PORT(blue)
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  using F = TopFormats;
  static_assert(!F::kPhong && !F::kHasMotion, "shade_phong and motion_field stand in its place");
  const Frame<TopFormats> frame = background_frame(red, green, blue);
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
  ShadingDatabase<F> database_view = {Words<Planes<F>>(database)};
  shade_gouraud_frame(frame, scan_words, database_view, pixel_words);
}
