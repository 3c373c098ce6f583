// SPDX-License-Identifier: Apache-2.0
#include "hls/setup/shade_setup.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void shade_setup_top(Port<Attributes>& attributes, Port<Planes>& planes) {
  HS_STREAM_PORT(attributes)
  HS_STREAM_PORT(planes)
  HS_STARTED
  using F = TopFormats;
  static_assert(!F::kHasLighting && !F::kHasMotion, "colours come with the attributes");
  View<Attributes> attributes_words(attributes);
  View<Planes> planes_words(planes);
Words:
  while (!shade_setup(attributes_words, planes_words)) {}
}
