// SPDX-License-Identifier: Apache-2.0
// Processes of composed tops from triangles to what is visible of them. A call is a frame.
#ifndef HALFSPACE_HLS_TOP_COMPOSED_DRAW_PROCESSES_HPP_
#define HALFSPACE_HLS_TOP_COMPOSED_DRAW_PROCESSES_HPP_

#include "hls/raster/raster_pineda.hpp"
#include "hls/setup/triangle_setup.hpp"
#include "hls/top/composed/frame_word.hpp"
#include "hls/ztest/visible_select.hpp"
#include "hls/ztest/ztest_index.hpp"

namespace halfspace {

inline void triangle_process(Port<FrameWord>& frame, Port<Triangle>& triangle, Port<Setup>& setup,
                             Port<Attributes>& attributes) {
  static_assert(!TopFormats::kGivesIndices, "no composed top has index_pool: results would run against the dataflow");
  const Frame<TopFormats> registers = read_frame(frame);
  View<Triangle> triangle_words(triangle);
  View<Setup> setup_words(setup);
  View<Attributes> attributes_words(attributes);
Words:
  while (!triangle_setup(registers, triangle_words, setup_words, attributes_words)) {}
}

inline void raster_process(Port<FrameWord>& frame, Port<Setup>& setup, Port<Stamp>& stamp) {
  const Frame<TopFormats> registers = read_frame(frame);
  View<Setup> setup_words(setup);
  View<Stamp> stamp_words(stamp);
  Probe<int> visits;
  View<TriangleDepth> depth_plane_words;  // none
  raster_pineda_frame(registers, setup_words, stamp_words, depth_plane_words, visits);
}

// The word of the frame goes on once its stamps are in the memories.
inline void test_process(MemoryWord<IndexStamp> index_buffer[IndexBuffer<TopFormats>::kWords],
                         MemoryWord<DepthStamp> depth_buffer[DepthBuffer<TopFormats>::kWords], Port<FrameWord>& frame,
                         Port<Stamp>& stamp, Port<Visible>& visible, Port<FrameWord>& tested_frame) {
  using F = TopFormats;
  static_assert(!F::kTestsPlanes, "type γ has no Z-buffer");
  const Packed<FrameWord<F>> word = frame.read();  // before it looks at a memory
  IndexBuffer<F> index_view = {Words<IndexStamp<F>>(index_buffer)};
  DepthBuffer<F> depth_view = {Words<DepthStamp<F>>(depth_buffer)};
  View<Stamp> stamp_words(stamp);
  View<Visible> visible_words(visible);
  Probe<Update<F>> update;
  ztest_index_frame(stamp_words, index_view, depth_view, update, visible_words);
  tested_frame.write(word);
}

// Deferred shading: what is visible goes on.
inline void select_process(Port<Attributes>& attributes, Port<Visible>& tested, Port<Visible>& visible,
                           Port<Attributes>& passed) {
  View<Attributes> attributes_words(attributes), passed_words(passed);
  View<Visible> tested_words(tested), visible_words(visible);
Words:
  while (!visible_select(attributes_words, tested_words, visible_words, passed_words)) {}
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_TOP_COMPOSED_DRAW_PROCESSES_HPP_
