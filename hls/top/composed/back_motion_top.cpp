// SPDX-License-Identifier: Apache-2.0
#include "hls/top/composed/field_process.hpp"
#include "hls/top/composed/scan_process.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

static_assert(TopFormats::kHasMotion, "motion_field is of configurations with motion");

namespace {

class BackMotion {
 public:
  void run(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
           MemoryWord<MotionPlanes> motion_database[MotionDatabase<TopFormats>::kWords], Port<FrameWord>& frame,
           Port<Motion>& motion) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    HS_DEPTH(scan_, TopDepths::scan)
    scan_process(index_buffer, frame, scan_);
    field_process(motion_database, scan_, motion);
  }

 private:
  Port<Scan> scan_;
};

}  // namespace

extern "C" void back_motion_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                MemoryWord<MotionPlanes> motion_database[MotionDatabase<TopFormats>::kWords],
                                Port<FrameWord>& frame, Port<Motion>& motion) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(motion_database)
  HS_STREAM_PORT(frame)
  HS_STREAM_PORT(motion)
  HS_STARTED
  static BackMotion back_motion;
  back_motion.run(index_buffer, motion_database, frame, motion);
}
