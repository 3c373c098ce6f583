// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/motion_order.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void motion_order_top(int width, int height, MemoryWord<Motion> buffer[frame_words<TopFormats>()],
                                 Port<Motion>& motion, Port<Motion>& ordered) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_MEMORY_PORT(buffer)
  HS_STREAM_PORT(motion)
  HS_STREAM_PORT(ordered)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kUpConverts, "motion_order is of configurations that make films");
  View<Motion> motion_words(motion);
  View<Motion> ordered_words(ordered);
  MotionBuffer<F> buffer_view = {Words<Motion<F>>(buffer)};
  motion_order_frame(top_frame(width, height), motion_words, buffer_view, ordered_words);
}
