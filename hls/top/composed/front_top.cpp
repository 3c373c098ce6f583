// SPDX-License-Identifier: Apache-2.0
#include "hls/top/composed/draw_processes.hpp"
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

class Front {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Triangle>& triangle, Port<Visible>& visible, Port<FrameWord>& drawn) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(setup_, TopDepths::setup)
    HS_DEPTH(attributes_, TopDepths::attributes)
    HS_DEPTH(stamp_, TopDepths::stamp)
    fork_frame(frame, setup_frame_, raster_frame_, test_frame_);
    triangle_process(setup_frame_, triangle, setup_, attributes_);
    raster_process(raster_frame_, setup_, stamp_);
    test_process(index_buffer, depth_buffer, test_frame_, stamp_, visible, tested_frame_);
    planes_process(attributes_, planes_);
    store_process(database, planes_, tested_frame_, drawn);
  }

 private:
  Port<FrameWord> setup_frame_, raster_frame_, test_frame_, tested_frame_;
  Port<Setup> setup_;
  Port<Attributes> attributes_;
  Port<Stamp> stamp_;
  Port<Planes> planes_;
};

}  // namespace

extern "C" void front_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                          MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                          MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
                          Port<Triangle>& triangle, Port<Visible>& visible, Port<FrameWord>& drawn) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(visible)
  HS_STREAM_PORT(drawn)
  HS_STARTED
  static Front front;
  front.run(index_buffer, depth_buffer, database, frame, triangle, visible, drawn);
}
