// SPDX-License-Identifier: Apache-2.0
#include "hls/texture/reciprocal_lookup.hpp"
#include "model/package/package_writer.hpp"

namespace halfspace::model {

void add_texture(PackageWriter& out) {
  using T = FormatTable;
  const Config& c = out.config();
  const bool there = has_perspective(c);
  const auto inverse = [&](const char* name, int value) { out.number(name, there ? value : 0); };
  out.constants({"Bilinear", "Perspective", "Texels", "Textures"});
  out.bits({&T::texture});
  out.number("RepeatBits", has_texture(c) ? out.table().repeats.width : 0);
  out.bits({&T::side, &T::texel_address, &T::coordinate});
  out.fields({"coordinate_fraction"});
  out.bits({&T::coordinate_plane});
  out.number("WeightBits", has_texture(c) ? kWeightBits : 0);
  out.bits({&T::texel_place});
  out.number("FilteredFraction", is_bilinear(c) ? kFilteredFraction : 0);
  out.bits({&T::filtered});
  out.word("Texture", "texture");
  out.words({"Texel", "TextureCoordinates", "TexturePlanes"});
  out.bits({&T::inverse, &T::inverse_shift});
  inverse("InverseIndexBits", kInverseIndexBits);
  inverse("InverseOffsetBits", kInverseOffsetBits);
  inverse("InverseValueFraction", kInverseValueFraction);
  inverse("InverseSlopeBits", kInverseSlopeBits);
  if (!there) return out.no_table("InverseTable");
  out.line("\n");
  out.entries("InverseTable", segments_of(inverse_table(), kInverseSegments, kInverseSlopeBits),
              kInverseValueFraction + kInverseSlopeBits, 6);
}

}  // namespace halfspace::model
