// SPDX-License-Identifier: Apache-2.0
#include "hls/ztest/ztest_plane.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void ztest_plane_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                MemoryWord<DepthEntry> database[VisibilityDatabase<TopFormats>::kWords],
                                Port<Stamp>& stamp, Port<TriangleDepth>& depth_plane, Port<Visible>& visible) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(database)
  HS_STREAM_PORT(stamp)
  HS_STREAM_PORT(depth_plane)
  HS_STREAM_PORT(visible)
  HS_STARTED
  using F = TopFormats;
  static_assert(F::kTestsPlanes, "ztest_plane is of type γ");
  View<Stamp> stamp_words(stamp);
  View<TriangleDepth> depth_plane_words(depth_plane);
  View<Visible> visible_words(visible);
  IndexBuffer<F> index_buffer_view = {Words<IndexStamp<F>>(index_buffer)};
  VisibilityDatabase<F> database_view = {Words<DepthEntry<F>>(database)};
  Probe<Update<F>> update;
  Probe<PlaneTests> tests;
  ztest_plane_frame(stamp_words, depth_plane_words, index_buffer_view, database_view, update, visible_words, tests);
}
