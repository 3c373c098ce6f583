// SPDX-License-Identifier: Apache-2.0
#include "hls/ztest/ztest_index.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void ztest_index_top(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                                MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords],
                                Port<Stamp>& stamp, Port<Visible>& visible) {
  HS_MEMORY_PORT(index_buffer)
  HS_MEMORY_PORT(depth_buffer)
  HS_STREAM_PORT(stamp)
  HS_STREAM_PORT(visible)
  HS_STARTED
  using F = TopFormats;
  static_assert(!F::kTestsPlanes, "type γ has ztest_plane_top");
  View<Stamp> stamp_words(stamp);
  View<Visible> visible_words(visible);
  IndexBuffer<F> index_buffer_view = {Words<IndexStamp<F>>(index_buffer)};
  DepthBuffer<F> depth_buffer_view = {Words<DepthStamp<F>>(depth_buffer)};
  Probe<Update<F>> update;
  ztest_index_frame(stamp_words, index_buffer_view, depth_buffer_view, update, visible_words);
}
