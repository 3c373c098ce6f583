// SPDX-License-Identifier: Apache-2.0
// Composed of the tops of units, in one translation unit with them: Bambu composes what it sees at once. A memory that
// two processes reach is in a process of both, which draws a frame and then scans it, or stores it and then shades it.
#include "hls/shade/shade_gouraud.hpp"
#include "hls/top/raster_pineda_top.cpp"
#include "hls/top/scan_index_top.cpp"
#include "hls/top/shade_gouraud_top.cpp"
#include "hls/top/shade_setup_top.cpp"
#include "hls/top/triangle_setup_top.cpp"
#include "hls/top/ztest_index_top.cpp"

namespace {

void draw_process(int width, int height, Port<Stamp>& stamp, Port<Visible>& visible, Port<Scan>& scan) {
  static MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords];
  static MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords];
  ztest_index_top(index_buffer, depth_buffer, stamp, visible);
  scan_index_top(width, height, index_buffer, scan);
}

void shade_process(int red, int green, int blue, Port<Planes>& planes, Port<Scan>& scan, Port<Pixel>& pixel) {
  static MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords];
  ShadingDatabase<TopFormats> view = {Words<Planes<TopFormats>>(database)};
  View<Planes> words(planes);
Words:
  while (!store_planes(words, view)) {}
  shade_gouraud_top(red, green, blue, database, scan, pixel);
}

class Pipeline {
 public:
  void run(int width, int height, int red, int green, int blue, Port<Triangle>& triangle, Port<Visible>& visible,
           Port<Pixel>& pixel) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, kTrianglesAhead)
    HS_DEPTH(attributes_, 4)
    HS_DEPTH(stamp_, 4)
    HS_DEPTH(scan_, 4)
    triangle_setup_top(width, height, triangle, setup_, attributes_);
    shade_setup_top(attributes_, planes_);
    raster_pineda_top(width, height, setup_, stamp_);
    draw_process(width, height, stamp_, visible, scan_);
    shade_process(red, green, blue, planes_, scan_, pixel);
  }

 private:
  Port<Setup> setup_;
  Port<Attributes> attributes_;
  Port<Planes> planes_;
  Port<Stamp> stamp_;
  Port<Scan> scan_;
};

}  // namespace

extern "C" void pipeline_top(int width, int height, int red, int green, int blue, Port<Triangle>& triangle,
                             Port<Visible>& visible, Port<Pixel>& pixel) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_REGISTER_PORT(red)
  HS_REGISTER_PORT(green)
  HS_REGISTER_PORT(blue)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  static Pipeline pipeline;
  pipeline.run(width, height, red, green, blue, triangle, visible, pixel);
}
