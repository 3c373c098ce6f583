// SPDX-License-Identifier: Apache-2.0
// Of a configuration with texture: HALFSPACE_TOP_CONFIG names it. The word of coordinates is not looked at if the
// attributes are empty.
#include "hls/texture/texture_setup.hpp"
#include "hls/top/fields.hpp"

using namespace halfspace;

extern "C" void texture_setup_top(const std::int64_t attributes[kAttributesFields],
                                  const std::int64_t coordinates[kTextureCoordinatesFields],
                                  std::int64_t planes[kTexturePlanesFields]) {
  using F = TopFormats;
  static_assert(F::kHasTexture, "texture_setup is of configurations with texture");
  Stream<Attributes<F>> in;
  Stream<TextureCoordinates<F>> given;
  Stream<TexturePlanes<F>> out;
  in.write(read_fields<Attributes<F>>(attributes));
  given.write(read_fields<TextureCoordinates<F>>(coordinates));
  texture_setup(in, given, out);
  write_fields(out.read(), planes);
}
