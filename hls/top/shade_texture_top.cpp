// SPDX-License-Identifier: Apache-2.0
#include "hls/texture/shade_texture.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void shade_texture_top(MemoryWord<TexturePlanes> database[TextureDatabase<TopFormats>::kWords],
                                  MemoryWord<TextureEntry> textures[TextureTable<TopFormats>::kWords],
                                  MemoryWord<TexelColour> texels[TextureMemory<TopFormats>::kWords], Port<Scan>& scan,
                                  Port<Pixel>& lit, Port<Pixel>& pixel) {
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
  TextureDatabase<F> database_view = {Words<TexturePlanes<F>>(database)};
  TextureTable<F> textures_view = {Words<TextureEntry<F>>(textures)};
  TextureMemory<F> texels_view = {WordRows<TexelColour<F>, TextureMemory<F>::kBankWords>(texels)};
  shade_texture_frame(scan_words, lit_words, database_view, textures_view, texels_view, pixel_words);
}
