// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// The stamps of one triangle, and for type γ its depth plane. Returns how many stamps.
extern "C" int raster_pineda_top(int width, int height, const std::int64_t setup[kSetupFields],
                                 std::int64_t stamp[TopFormats::kStamps * kStampFields],
                                 std::int64_t depth_plane[kTriangleDepthFields]) {
  using F = TopFormats;
  Stream<Setup<F>> in;
  Stream<Stamp<F>> out;
  in.write(read_fields<Setup<F>>(setup));
  Probe<int> visits;
  Stream<TriangleDepth<F>> depth;
  raster_pineda(top_frame(width, height, 0), in, out, depth, visits);
  if (F::kTestsPlanes) write_fields(depth.read(), depth_plane);
  int count = 0;
Stamps:
  for (int n = 0; n < F::kStamps; ++n) {
    if (out.empty()) break;
    write_fields(out.read(), stamp + n * kStampFields);
    ++count;
  }
  return count;
}
