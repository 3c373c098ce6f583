// SPDX-License-Identifier: Apache-2.0
#include "hls/texture/shade_texture.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void shade_texture_top(const TopTextureDatabase& database, const TopTextureTable& textures,
                                  const TopTextureMemory& texels, Port<Scan>& scan, Port<Pixel>& lit,
                                  Port<Pixel>& pixel) {
  HS_MEMORY_PORT(database)
  HS_MEMORY_PORT(textures)
  HS_MEMORY_PORT(texels)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(lit)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasTexture, "shade_texture is of configurations with texture");
  View<Scan> scan_words(scan);
  View<Pixel> lit_words(lit);
  View<Pixel> pixel_words(pixel);
Words:
  while (!shade_texture(scan_words, lit_words, database, textures, texels, pixel_words)) {}
}
