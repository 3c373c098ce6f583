// SPDX-License-Identifier: Apache-2.0
// Triangles in, visibility out: which unit feeds which, as far as the I-buffer.
//
//   triangle ─► triangle_setup ─setup─► raster_pineda ─stamp─► Z-test ─► visible
//                     └─ attributes                               └ update ─► I-buffer; Z-buffer or TdbV
//
// With F::kGivesIndices index_pool stands before triangle_setup, and hears each `visible` too.
#ifndef HALFSPACE_HLS_PIPELINE_FRONT_HPP_
#define HALFSPACE_HLS_PIPELINE_FRONT_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/motion/pixel_store.hpp"
#include "hls/objects/scan_object.hpp"
#include "hls/pipeline/choose.hpp"
#include "hls/pipeline/pipeline_streams.hpp"
#include "hls/raster/raster_pineda.hpp"
#include "hls/setup/triangle_setup.hpp"
#include "hls/ztest/index_pool.hpp"
#include "hls/ztest/visible_select.hpp"
#include "hls/ztest/ztest_index.hpp"
#include "hls/ztest/ztest_plane.hpp"

namespace halfspace {

// One triangle from s.triangle, or s.unnumbered, into the I-buffer, and what geometry hears of it into s.visible.
template <class F>
void pipeline_triangle(const Frame<F>& frame, Streams<F>& s, Buffers<F>& b) {
  if (F::kGivesIndices) index_pool(s.unnumbered, s.returned, b.pool, s.numbered);
  Stream<Triangle<F>>& triangle = F::kGivesIndices ? s.numbered : s.triangle;
  if (F::kHasObjects) {
    fork(triangle, s.drawn_triangle, s.numbered_triangle);
    store_object(s.numbered_triangle, b.objects);
  }
  if (F::kUpConverts) {
    fork(triangle, s.drawn_triangle, s.faced_triangle);
    store_face(s.faced_triangle, b.faces);
  }
  triangle_setup(frame, F::kHasObjects || F::kUpConverts ? s.drawn_triangle : triangle, s.setup, s.attributes);
  raster_pineda(frame, s.setup, s.stamp, s.triangle_depth, s.visits);
  Stream<Visible<F>>& selected = F::kGivesIndices ? s.selected : s.visible;
  Stream<Visible<F>>& tested = F::kDeferred ? s.tested : selected;
  choose(
      typename F::CompilesPlaneTest(), F::kTestsPlanes, s, b,
      [&](auto& s, auto& b) {
        ztest_plane(s.stamp, s.triangle_depth, b.index, b.visibility, s.update, tested, s.tests);
      },
      [&](auto& s, auto& b) { ztest_index(s.stamp, b.index, b.depth, s.update, tested); });
  if (F::kDeferred) visible_select(s.attributes, tested, selected, s.visible_attributes);
  if (F::kGivesIndices) fork(s.selected, s.visible, s.returned);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_FRONT_HPP_
