// SPDX-License-Identifier: Apache-2.0
// A memory that two units reach is in a process of both, which draws a frame and then scans it, or stores it and then
// shades it.
#include "hls/shade/scan_index.hpp"
#include "hls/top/composed/draw_processes.hpp"
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

void draw_process(Port<FrameWord>& frame, Port<Stamp>& stamp, Port<Visible>& visible, Port<Scan>& scan) {
  using F = TopFormats;
  static_assert(!F::kTestsPlanes, "type γ has no Z-buffer");
  static MemoryWord<IndexStamp> index_words[IndexBuffer<F>::kWords];
  static MemoryWord<DepthStamp> depth_words[DepthBuffer<F>::kWords];
  const Frame<F> registers = read_frame(frame);
  IndexBuffer<F> index_buffer = {Words<IndexStamp<F>>(index_words)};
  DepthBuffer<F> depth_buffer = {Words<DepthStamp<F>>(depth_words)};
  View<Stamp> stamp_words(stamp);
  View<Visible> visible_words(visible);
  View<Scan> scan_words(scan);
  Probe<Update<F>> update;
  ztest_index_frame(stamp_words, index_buffer, depth_buffer, update, visible_words);
  scan_index_frame(registers, index_buffer, scan_words);
}

void colour_process(Port<FrameWord>& frame, Port<Planes>& planes, Port<Scan>& scan, Port<Pixel>& pixel) {
  using F = TopFormats;
  static MemoryWord<Planes> words[ShadingDatabase<F>::kWords];
  const Frame<F> registers = read_frame(frame);
  ShadingDatabase<F> database = {Words<Planes<F>>(words)};
  View<Planes> planes_words(planes);
  View<Scan> scan_words(scan);
  View<Pixel> pixel_words(pixel);
Words:
  while (!store_planes(planes_words, database)) {}
  shade_gouraud_frame(registers, scan_words, database, pixel_words);
}

class Pipeline {
 public:
  void run(Port<FrameWord>& frame, Port<Triangle>& triangle, Port<Visible>& visible, Port<Pixel>& pixel) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, TopDepths::setup)
    HS_DEPTH(attributes_, TopDepths::attributes)
    HS_DEPTH(stamp_, TopDepths::stamp)
    HS_DEPTH(scan_, TopDepths::scan)
    fork_frame(frame, setup_frame_, raster_frame_, draw_frame_, shade_frame_);
    triangle_process(setup_frame_, triangle, setup_, attributes_);
    planes_process(attributes_, planes_);
    raster_process(raster_frame_, setup_, stamp_);
    draw_process(draw_frame_, stamp_, visible, scan_);
    colour_process(shade_frame_, planes_, scan_, pixel);
  }

 private:
  Port<FrameWord> setup_frame_, raster_frame_, draw_frame_, shade_frame_;
  Port<Setup> setup_;
  Port<Attributes> attributes_;
  Port<Planes> planes_;
  Port<Stamp> stamp_;
  Port<Scan> scan_;
};

}  // namespace

extern "C" void pipeline_top(Port<FrameWord>& frame, Port<Triangle>& triangle, Port<Visible>& visible,
                             Port<Pixel>& pixel) {
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  static Pipeline pipeline;
  pipeline.run(frame, triangle, visible, pixel);
}
