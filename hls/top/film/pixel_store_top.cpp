// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/pixel_store.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void pixel_store_top(int width, int height, MemoryWord<FaceEntry> faces[FaceTable<TopFormats>::kWords],
                                Port<Scan>& scan, Port<Pixel>& pixel, Port<ShownPixel>& shown) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_MEMORY_PORT(faces)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(pixel)
  HS_STREAM_PORT(shown)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kUpConverts, "pixel_store is of configurations that make films");
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
  View<ShownPixel> shown_words(shown);
  const FaceTable<F> faces_view = {Words<FaceEntry<F>>(faces)};
  pixel_store_frame(top_frame(width, height), scan_words, pixel_words, faces_view, shown_words);
}
