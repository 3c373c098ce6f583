// SPDX-License-Identifier: Apache-2.0
// Of a motion configuration: HALFSPACE_TOP_CONFIG names it. The word of vectors is not looked at if the attributes are
// empty.
#include "hls/motion/motion_setup.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void motion_setup_top(const std::int64_t attributes[kAttributesFields],
                                 const std::int64_t vectors[kMotionVectorsFields],
                                 std::int64_t planes[kMotionPlanesFields]) {
  using F = TopFormats;
  static_assert(F::kHasMotion, "motion_setup is of motion configurations");
  Stream<Attributes<F>> in;
  Stream<MotionVectors<F>> given;
  Stream<MotionPlanes<F>> out;
  in.write(read_fields<Attributes<F>>(attributes));
  given.write(read_fields<MotionVectors<F>>(vectors));
  motion_setup(in, given, out);
  write_fields(out.read(), planes);
}
