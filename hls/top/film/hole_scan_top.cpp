// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/hole_scan.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void hole_scan_top(int fills, MemoryWord<HoleStamp> holes[HoleMarks<TopFormats>::kWords], Port<Scan>& scan,
                              Port<Scan>& masked) {
  HS_REGISTER_PORT(fills)
  HS_MEMORY_PORT(holes)
  HS_STREAM_PORT(scan)
  HS_STREAM_PORT(masked)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kUpConverts, "hole_scan is of configurations that make films");
  View<Scan> scan_words(scan);
  View<Scan> masked_words(masked);
  HoleMarks<F> holes_view = {Words<HoleStamp<F>>(holes)};
  hole_scan_frame(fills != 0, scan_words, holes_view, masked_words);
}
