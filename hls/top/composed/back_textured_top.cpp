// SPDX-License-Identifier: Apache-2.0
#include "hls/texture/shade_texture.hpp"
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/composed/scan_process.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

void texture_process(MemoryWord<TexturePlanes> texture_database[TextureDatabase<TopFormats>::kWords],
                     MemoryWord<TextureEntry> textures[TextureTable<TopFormats>::kWords],
                     MemoryWord<TexelColour> texels[TextureMemory<TopFormats>::kWords], Port<Scan>& scan,
                     Port<Pixel>& lit, Port<Pixel>& pixel) {
  using F = TopFormats;
  static_assert(F::kHasTexture, "shade_texture is of configurations with texture");
  TextureDatabase<F> database_view = {Words<TexturePlanes<F>>(texture_database)};
  TextureTable<F> textures_view = {Words<TextureEntry<F>>(textures)};
  TextureMemory<F> texels_view = {WordRows<TexelColour<F>, TextureMemory<F>::kBankWords>(texels)};
  View<Scan> scan_words(scan);
  View<Pixel> lit_words(lit), pixel_words(pixel);
  shade_texture_frame(scan_words, lit_words, database_view, textures_view, texels_view, pixel_words);
}

class BackTextured {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
           MemoryWord<TexturePlanes> texture_database[TextureDatabase<TopFormats>::kWords],
           MemoryWord<TextureEntry> textures[TextureTable<TopFormats>::kWords],
           MemoryWord<TexelColour> texels[TextureMemory<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Pixel>& pixel) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(coloured_scan_, TopDepths::coloured_scan)
    HS_DEPTH(texed_scan_, TopDepths::texed_scan)
    fork_frame(frame, scan_frame_, shade_frame_);
    scan_process(index_buffer, scan_frame_, scan_);
    fork_scan(scan_, coloured_scan_, texed_scan_);
    shade_process(database, shade_frame_, coloured_scan_, lit_);
    texture_process(texture_database, textures, texels, texed_scan_, lit_, pixel);
  }

 private:
  Port<FrameWord> scan_frame_, shade_frame_;
  Port<Scan> scan_, coloured_scan_, texed_scan_;
  Port<Pixel> lit_;
};

}  // namespace

extern "C" void back_textured_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                  MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
                                  MemoryWord<TexturePlanes> texture_database[TextureDatabase<TopFormats>::kWords],
                                  MemoryWord<TextureEntry> textures[TextureTable<TopFormats>::kWords],
                                  MemoryWord<TexelColour> texels[TextureMemory<TopFormats>::kWords],
                                  Port<FrameWord>& frame, Port<Pixel>& pixel) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(database)
  HS_MEMORY_PORT(texture_database)
  HS_MEMORY_PORT(textures)
  HS_MEMORY_PORT(texels)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  static BackTextured back_textured;
  back_textured.run(index_buffer, database, texture_database, textures, texels, frame, pixel);
}
