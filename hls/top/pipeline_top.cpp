// SPDX-License-Identifier: Apache-2.0
// Composed of the tops of units, in one translation unit with them: Bambu composes what it sees at once. A memory that
// two processes reach is in a process of both, which draws a frame and then scans it, or stores it and then shades it.
#include "hls/shade/scan_index.hpp"
#include "hls/shade/shade_gouraud.hpp"
#include "hls/top/raster_pineda_top.cpp"
#include "hls/top/shade_setup_top.cpp"
#include "hls/top/triangle_setup_top.cpp"
#include "hls/ztest/ztest_index.hpp"

namespace {

void draw_process(int width, int height, Port<Stamp>& stamp, Port<Visible>& visible, Port<Scan>& scan) {
  using F = TopFormats;
  static_assert(!F::kTestsPlanes, "type γ has no Z-buffer");
  static MemoryWord<IndexStamp> index_words[IndexBuffer<F>::kWords];
  static MemoryWord<DepthStamp> depth_words[DepthBuffer<F>::kWords];
  IndexBuffer<F> index_buffer = {Words<IndexStamp<F>>(index_words)};
  DepthBuffer<F> depth_buffer = {Words<DepthStamp<F>>(depth_words)};
  View<Stamp> stamp_words(stamp);
  View<Visible> visible_words(visible);
  View<Scan> scan_words(scan);
  Probe<Update<F>> update;
  ztest_index_frame(stamp_words, index_buffer, depth_buffer, update, visible_words);
  scan_index_frame(top_frame(width, height), index_buffer, scan_words);
}

void shade_process(int red, int green, int blue, Port<Planes>& planes, Port<Scan>& scan, Port<Pixel>& pixel) {
  using F = TopFormats;
  static MemoryWord<Planes> words[ShadingDatabase<F>::kWords];
  ShadingDatabase<F> database = {Words<Planes<F>>(words)};
  View<Planes> planes_words(planes);
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
Words:
  while (!store_planes(planes_words, database)) {}
  shade_gouraud_frame(background_frame(red, green, blue), scan_words, database, pixel_words);
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
