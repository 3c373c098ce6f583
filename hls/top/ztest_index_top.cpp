// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// The stamps of one triangle, into the caller's buffers.
extern "C" void ztest_index_top(int count, const std::int64_t stamp[TopFormats::kStamps * kStampFields],
                                IndexBuffer<TopFormats>* index_buffer, DepthBuffer<TopFormats>* depth_buffer,
                                std::int64_t visible[kVisibleFields]) {
  using F = TopFormats;
  Stream<Stamp<F>> in;
  Probe<Update<F>> update;
  Stream<Visible<F>> out;
Stamps:
  for (int n = 0; n < F::kStamps; ++n) {
    if (n == count) break;
    in.write(read_fields<Stamp<F>>(stamp + n * kStampFields));
  }
  ztest_index(in, *index_buffer, *depth_buffer, update, out);
  write_fields(out.read(), visible);
}
