// SPDX-License-Identifier: Apache-2.0
#include "hls/raster/raster_pineda.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void raster_pineda_top(int width, int height, Port<Setup>& setup, Port<Stamp>& stamp) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_STREAM_PORT(setup)
  HS_STREAM_PORT(stamp)
  HS_STARTED
  using F = TopFormats;
  static_assert(!F::kTestsPlanes, "raster_pineda_plane_top sends depth planes too");
  const Frame<TopFormats> frame = top_frame(width, height);
  View<Setup> setup_words(setup);
  View<Stamp> stamp_words(stamp);
  Probe<int> visits;
  View<TriangleDepth> depth_plane_words;  // none
  raster_pineda_frame(frame, setup_words, stamp_words, depth_plane_words, visits);
}
