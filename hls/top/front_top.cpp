// SPDX-License-Identifier: Apache-2.0
// Composed of the tops of units, in one translation unit with them: Bambu composes what it sees at once.
#include "hls/shade/shade_gouraud.hpp"
#include "hls/top/raster_pineda_top.cpp"
#include "hls/top/shade_setup_top.cpp"
#include "hls/top/triangle_setup_top.cpp"
#include "hls/top/ztest_index_top.cpp"

namespace {

// A frame of planes into TdbS.
void store_planes_process(MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Planes>& planes) {
  ShadingDatabase<TopFormats> view = {Words<Planes<TopFormats>>(database)};
  View<Planes> words(planes);
Words:
  while (!store_planes(words, view)) {}
}

class Front {
 public:
  void run(int width, int height, MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Triangle>& triangle,
           Port<Visible>& visible) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, kTrianglesAhead)
    HS_DEPTH(attributes_, 4)
    HS_DEPTH(stamp_, 4)
    triangle_setup_top(width, height, triangle, setup_, attributes_);
    shade_setup_top(attributes_, planes_);
    store_planes_process(database, planes_);
    raster_pineda_top(width, height, setup_, stamp_);
    ztest_index_top(index_buffer, depth_buffer, stamp_, visible);
  }

 private:
  Port<Setup> setup_;
  Port<Attributes> attributes_;
  Port<Planes> planes_;
  Port<Stamp> stamp_;
};

}  // namespace

extern "C" void front_top(int width, int height, MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                          MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                          MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<Triangle>& triangle,
                          Port<Visible>& visible) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(visible)
  HS_STARTED
  static Front front;
  front.run(width, height, index_buffer, depth_buffer, database, triangle, visible);
}
