// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/scan_index.hpp"

#include "hls/top/tops.hpp"

using namespace halfspace;

extern "C" void scan_index_top(int width, int height,
                               MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords], Port<Scan>& scan) {
  HS_REGISTER_PORT(width)
  HS_REGISTER_PORT(height)
  HS_MEMORY_PORT(index_buffer)
  HS_STREAM_PORT(scan)
  HS_STARTED
  using F = TopFormats;
  const Frame<TopFormats> frame = top_frame(width, height);
  View<Scan> scan_words(scan);
  IndexBuffer<F> index_buffer_view = {Words<IndexStamp<F>>(index_buffer)};
  scan_index_frame(frame, index_buffer_view, scan_words);
}
