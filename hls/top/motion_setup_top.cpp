// SPDX-License-Identifier: Apache-2.0
#include "hls/motion/motion_setup.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void motion_setup_top(Port<Attributes>& attributes, Port<MotionVectors>& vectors,
                                 Port<MotionPlanes>& planes) {
  HS_STREAM_PORT(attributes)
  HS_STREAM_PORT(vectors)
  HS_STREAM_PORT(planes)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kHasMotion, "motion_setup is of configurations with motion");
  View<Attributes> attributes_words(attributes);
  View<MotionVectors> vectors_words(vectors);
  View<MotionPlanes> planes_words(planes);
Words:
  while (!motion_setup(attributes_words, vectors_words, planes_words)) {}
}
