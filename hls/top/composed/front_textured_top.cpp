// SPDX-License-Identifier: Apache-2.0
#include "hls/texture/shade_texture.hpp"
#include "hls/texture/texture_setup.hpp"
#include "hls/top/composed/draw_processes.hpp"
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

// Attributes to both shaders of triangles.
void fork_attributes(Port<Attributes>& attributes, Port<Attributes>& first, Port<Attributes>& second) {
  View<Attributes> attributes_words(attributes), first_words(first), second_words(second);
  bool done = false;
Words:
  while (!done) {
    const Attributes<TopFormats> word = attributes_words.read();
    first_words.write(word);
    second_words.write(word);
    done = is_set(word.last);
  }
}

void texture_setup_process(Port<Attributes>& attributes, Port<TextureCoordinates>& coordinates,
                           Port<TexturePlanes>& planes) {
  static_assert(TopFormats::kHasTexture, "texture_setup is of configurations with texture");
  View<Attributes> attributes_words(attributes);
  View<TextureCoordinates> coordinates_words(coordinates);
  View<TexturePlanes> planes_words(planes);
Words:
  while (!texture_setup(attributes_words, coordinates_words, planes_words)) {}
}

void store_texture_process(MemoryWord<TexturePlanes> database[TextureDatabase<TopFormats>::kWords],
                           Port<TexturePlanes>& planes, Port<FrameWord>& frame, Port<FrameWord>& stored_frame) {
  TextureDatabase<TopFormats> view = {Words<TexturePlanes<TopFormats>>(database)};
  View<TexturePlanes> planes_words(planes);
Words:
  while (!store_planes(planes_words, view)) {}
  stored_frame.write(frame.read());
}

class FrontTextured {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
           MemoryWord<TexturePlanes> texture_database[TextureDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Triangle>& triangle, Port<TextureCoordinates>& coordinates, Port<Visible>& visible,
           Port<FrameWord>& drawn) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, TopDepths::setup)
    HS_DEPTH(attributes_, TopDepths::attributes)
    HS_DEPTH(stamp_, TopDepths::stamp)
    fork_frame(frame, setup_frame_, raster_frame_, test_frame_);
    triangle_process(setup_frame_, triangle, setup_, attributes_);
    raster_process(raster_frame_, setup_, stamp_);
    test_process(index_buffer, depth_buffer, test_frame_, stamp_, tested_, tested_frame_);
    select_process(attributes_, tested_, visible, passed_);
    fork_attributes(passed_, coloured_, texed_);
    planes_process(coloured_, planes_);
    store_process(database, planes_, tested_frame_, shaded_frame_);
    texture_setup_process(texed_, coordinates, coordinate_planes_);
    store_texture_process(texture_database, coordinate_planes_, shaded_frame_, drawn);
  }

 private:
  Port<FrameWord> setup_frame_, raster_frame_, test_frame_, tested_frame_, shaded_frame_;
  Port<Setup> setup_;
  Port<Attributes> attributes_, passed_, coloured_, texed_;
  Port<Stamp> stamp_;
  Port<Visible> tested_;
  Port<Planes> planes_;
  Port<TexturePlanes> coordinate_planes_;
};

}  // namespace

extern "C" void front_textured_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                   MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                                   MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords],
                                   MemoryWord<TexturePlanes> texture_database[TextureDatabase<TopFormats>::kWords],
                                   Port<FrameWord>& frame, Port<Triangle>& triangle,
                                   Port<TextureCoordinates>& coordinates, Port<Visible>& visible,
                                   Port<FrameWord>& drawn) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(database)
  HS_MEMORY_PORT(texture_database)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(coordinates)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(drawn)
  HS_STARTED
  static FrontTextured front_textured;
  front_textured.run(index_buffer, depth_buffer, database, texture_database, frame, triangle, coordinates, visible,
                     drawn);
}
