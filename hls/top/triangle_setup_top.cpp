// SPDX-License-Identifier: Apache-2.0
#include "hls/setup/triangle_setup.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void triangle_setup_top(int width, int height, Port<Triangle>& triangle, Port<Setup>& setup,
                                   Port<Attributes>& attributes) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_STREAM_PORT(triangle)
  HS_STREAM_PORT(setup)
  HS_STREAM_PORT(attributes)
  HS_STARTED
  const Frame<TopFormats> frame = top_frame(width, height);
  View<Triangle> triangle_words(triangle);
  View<Setup> setup_words(setup);
  View<Attributes> attributes_words(attributes);
Words:
  while (!triangle_setup(frame, triangle_words, setup_words, attributes_words)) {}
}
