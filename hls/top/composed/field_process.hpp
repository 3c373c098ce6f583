// SPDX-License-Identifier: Apache-2.0
// The process of composed tops that makes a motion field. A call is a frame.
#ifndef HALFSPACE_HLS_TOP_COMPOSED_FIELD_PROCESS_HPP_
#define HALFSPACE_HLS_TOP_COMPOSED_FIELD_PROCESS_HPP_

#include "hls/motion/motion_field.hpp"
#include "hls/top/ports/ports.hpp"

namespace halfspace {

inline void field_process(MemoryWord<MotionPlanes> database[MotionDatabase<TopFormats>::kWords], Port<Scan>& scan,
                          Port<Motion>& motion) {
  using F = TopFormats;
  MotionDatabase<F> view = {Words<MotionPlanes<F>>(database)};
  View<Scan> scan_words(scan);
  View<Motion> motion_words(motion);
  motion_field_frame(scan_words, view, motion_words);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_COMPOSED_FIELD_PROCESS_HPP_
