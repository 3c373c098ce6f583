// SPDX-License-Identifier: Apache-2.0
// The top function of light_vertex, fields as plain integers, gives the colours of the kernels.
#include <gtest/gtest.h>

#include <memory>

#include "hls/top/fields.hpp"
#include "vectors/field_value.hpp"
#include "vectors/lighting_engine.hpp"

extern "C" void light_vertex_top(const std::int64_t*, const halfspace::LightTable<halfspace::TopFormats>*,
                                 const halfspace::MaterialTable<halfspace::TopFormats>*, std::int64_t*);

namespace halfspace::tests {
namespace {

using F = TopFormats;
using vectors::Word;

std::vector<std::int64_t> fields_of(const vectors::Layout& layout, const Word& word) {
  std::vector<std::int64_t> fields;
  for (const vectors::Field& field : layout.fields) fields.push_back(vectors::field_value(word, field));
  return fields;
}

TEST(LightTops, GiveTheWordsOfTheKernels) {
  const auto engine = vectors::make_lighting_engine(F::config());
  auto lights = std::make_unique<LightTable<F>>();
  auto materials = std::make_unique<MaterialTable<F>>();
  int compared = 0;
  for (const vectors::LightingFrame& frame : vectors::lighting_frames(F::config(), 4)) {
    std::vector<std::vector<std::vector<std::int64_t>>> streams;
    engine->capture(frame, [&](const vectors::Layout& layout, const Word* words, std::size_t count) {
      auto& stream = streams.emplace_back();
      for (std::size_t n = 0; n < count; ++n) stream.push_back(fields_of(layout, words[n]));
    });
    ASSERT_EQ(streams.size(), 4u);
    for (const auto& fields : streams[0]) {
      ASSERT_EQ(int(fields.size()), kLightFields);
      lights->light[fields[0]] = read_fields<Light<F>>(fields.data());
    }
    for (const auto& fields : streams[1]) {
      ASSERT_EQ(int(fields.size()), kMaterialFields);
      materials->entry[fields[0]][fields[1]] = read_fields<Material<F>>(fields.data());
    }
    ASSERT_EQ(streams[2].size(), streams[3].size());
    for (std::size_t n = 0; n < streams[2].size(); ++n, ++compared) {
      ASSERT_EQ(int(streams[2][n].size()), kNormalsFields);
      std::vector<std::int64_t> colours(kColoursFields, -1);
      light_vertex_top(streams[2][n].data(), lights.get(), materials.get(), colours.data());
      ASSERT_EQ(colours, streams[3][n]) << frame.note << ", word " << n;
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace halfspace::tests
