// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/motion_field.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void motion_field_top(MemoryWord<MotionPlanes> database[MotionDatabase<TopFormats>::kWords],
                                 Port<Scan>& scan, Port<Motion>& motion) {
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(motion)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasMotion, "motion_field is of configurations with motion");
  View<Scan> scan_words(scan);
  View<Motion> motion_words(motion);
  MotionDatabase<F> database_view = {Words<MotionPlanes<F>>(database)};
  motion_field_frame(scan_words, database_view, motion_words);
}
