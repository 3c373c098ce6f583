// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// Row `y` of stamps in the caller's I-buffer, which is cleared there. Returns the number of stamps.
extern "C" int scan_index_top(int width, int height, int y, IndexBuffer<TopFormats>* index_buffer,
                              std::int64_t scan[TopFormats::kStampsX * kScanFields]) {
  using F = TopFormats;
  Stream<Scan<F>> out;
  scan_index(top_frame(width, height, 0), y, *index_buffer, out);
  int count = 0;
Stamps:
  for (int n = 0; n < F::kStampsX; ++n) {
    if (out.empty()) break;
    write_fields(out.read(), scan + n * kScanFields);
    ++count;
  }
  return count;
}
