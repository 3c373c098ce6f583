// SPDX-License-Identifier: Apache-2.0
// Of a configuration with Phong shading: HALFSPACE_TOP_CONFIG names it.
#include "hls/shade/shade_phong.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void shade_phong_top(int background, const std::int64_t scan[kScanFields],
                                const NormalDatabase<TopFormats>* database, const LightTable<TopFormats>* lights,
                                const MaterialTable<TopFormats>* materials, std::int64_t pixel[kPixelFields]) {
  using F = TopFormats;
  static_assert(F::kPhong, "shade_phong is of configurations with Phong shading");
  Stream<Scan<F>> in;
  Stream<Pixel<F>> out;
  in.write(read_fields<Scan<F>>(scan));
  shade_phong(top_frame(0, 0, background), in, *database, *lights, *materials, out);
  write_fields(out.read(), pixel);
}
