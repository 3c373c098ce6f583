// SPDX-License-Identifier: Apache-2.0
// Of a motion configuration: HALFSPACE_TOP_CONFIG names it. Returns the words of the stamp, a lane each at most.
#include "hls/motion/motion_field.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" int motion_field_top(const std::int64_t scan[kScanFields], const MotionDatabase<TopFormats>* database,
                                std::int64_t motion[TopFormats::kLanes][kMotionFields]) {
  using F = TopFormats;
  static_assert(F::kHasMotion, "motion_field is of motion configurations");
  Stream<Scan<F>> in;
  Stream<Motion<F>> out;
  in.write(read_fields<Scan<F>>(scan));
  motion_field(in, *database, out);
  int words = 0;
Words:
  while (!out.empty()) write_fields(out.read(), motion[words++]);
  return words;
}
