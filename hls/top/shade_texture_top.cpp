// SPDX-License-Identifier: Apache-2.0
// Of a configuration with texture: HALFSPACE_TOP_CONFIG names it.
#include "hls/texture/shade_texture.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void shade_texture_top(const std::int64_t scan[kScanFields], const std::int64_t lit[kPixelFields],
                                  const TextureDatabase<TopFormats>* database, const TextureTable<TopFormats>* textures,
                                  const TextureMemory<TopFormats>* memory, std::int64_t pixel[kPixelFields]) {
  using F = TopFormats;
  static_assert(F::kHasTexture, "shade_texture is of configurations with texture");
  Stream<Scan<F>> in;
  Stream<Pixel<F>> before;
  Stream<Pixel<F>> out;
  in.write(read_fields<Scan<F>>(scan));
  before.write(read_fields<Pixel<F>>(lit));
  shade_texture(in, before, *database, *textures, *memory, out);
  write_fields(out.read(), pixel);
}
