// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// The stamps of one triangle, into the caller's I-buffer and TdbV: the Z-test of type γ.
extern "C" void ztest_plane_top(int count, const std::int64_t stamp[TopFormats::kStamps * kStampFields],
                                const std::int64_t depth_plane[kTriangleDepthFields],
                                IndexBuffer<TopFormats>* index_buffer, VisibilityDatabase<TopFormats>* database,
                                std::int64_t visible[kVisibleFields]) {
  using F = TopFormats;
  Stream<Stamp<F>> in;
  Stream<TriangleDepth<F>> depth;
  Probe<Update<F>> update;
  Stream<Visible<F>> out;
  Probe<PlaneTests> tests;
  depth.write(read_fields<TriangleDepth<F>>(depth_plane));
Stamps:
  for (int n = 0; n < F::kStamps; ++n) {
    if (n == count) break;
    in.write(read_fields<Stamp<F>>(stamp + n * kStampFields));
  }
  ztest_plane(in, depth, *index_buffer, *database, update, out, tests);
  write_fields(out.read(), visible);
}
