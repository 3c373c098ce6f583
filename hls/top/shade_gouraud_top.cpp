// SPDX-License-Identifier: Apache-2.0
#include "hls/top/fields.hpp"

using namespace halfspace;

// One stamp, from the caller's TdbS. `background` is 0xrrggbb.
extern "C" void shade_gouraud_top(int background, const std::int64_t scan[kScanFields],
                                  const ShadingDatabase<TopFormats>* database, std::int64_t pixel[kPixelFields]) {
  using F = TopFormats;
  Stream<Scan<F>> in;
  Stream<Pixel<F>> out;
  in.write(read_fields<Scan<F>>(scan));
  shade_gouraud(top_frame(F::kWidth, F::kHeight, background), in, *database, out);
  write_fields(out.read(), pixel);
}
