// SPDX-License-Identifier: Apache-2.0
#include "hls/top/composed/gouraud_processes.hpp"
#include "hls/top/composed/scan_process.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

class Back {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Pixel>& pixel) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(scan_, TopDepths::scan)
    fork_frame(frame, scan_frame_, shade_frame_);
    scan_process(index_buffer, scan_frame_, scan_);
    shade_process(database, shade_frame_, scan_, pixel);
  }

 private:
  Port<FrameWord> scan_frame_, shade_frame_;
  Port<Scan> scan_;
};

}  // namespace

extern "C" void back_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                         MemoryWord<Planes> database[ShadingDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
                         Port<Pixel>& pixel) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(pixel)
  HS_STARTED
  static Back back;
  back.run(index_buffer, database, frame, pixel);
}
