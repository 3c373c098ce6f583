// SPDX-License-Identifier: Apache-2.0
#include "hls/shade/reciprocal_sqrt.hpp"
#include "model/package/package_writer.hpp"

namespace halfspace::model {

void add_lighting(PackageWriter& out) {
  using T = FormatTable;
  const NumberFormat sum = out.table().light_sum;
  const bool there = has_lighting(out.config());
  const auto number = [&](const char* name, int value) { out.number(name, there ? value : 0); };
  out.constants({"Deferred", "Lights"});
  out.words({"Light", "Material", "Normals", "Colours"});
  out.bits({&T::normal, &T::light});
  out.constants({"Materials"});
  out.bits({&T::material});
  out.constants({"HasGloss", "Squarings"});
  out.bits({&T::gloss, &T::direction, &T::squared_length});
  number("RootIndexBits", kRootIndexBits);
  number("RootOffsetBits", kRootOffsetBits);
  number("RootValueFraction", kRootValueFraction);
  number("RootSlopeBits", kRootSlopeBits);
  out.bits({&T::root, &T::root_shift, &T::dot, &T::cosine, &T::coefficient, &T::light_sum});
  number("LightSumFraction", sum.width - sum.integer);
  out.fields({"normal_fraction"});
  out.bits({&T::normal_plane});
  if (!there) return out.no_table("RootTable");
  out.line("\n");
  out.entries("RootTable", segments_of(root_table(), kRootSegments, kRootSlopeBits),
              kRootValueFraction + kRootSlopeBits, 6);
}

}  // namespace halfspace::model
