// SPDX-License-Identifier: Apache-2.0
// The top functions of deferred lighting, fields as plain integers, give the words of the kernels.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include "hls/top/fields.hpp"
#include "model/formats/field_value.hpp"
#include "model/pipeline/engine.hpp"
#include "model/shade/lighting_engine.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

extern "C" void light_vertex_top(const std::int64_t*, const halfspace::LightTable<halfspace::TopFormats>*,
                                 const halfspace::MaterialTable<halfspace::TopFormats>*, std::int64_t*);

extern "C" int visible_select_top(const std::int64_t*, const std::int64_t*, std::int64_t*, std::int64_t*);
extern "C" void shade_setup_lit_top(const std::int64_t*, const std::int64_t*, std::int64_t*);

namespace halfspace::tests {
namespace {

using F = TopFormats;
using model::Word;

std::vector<std::int64_t> fields_of(const model::Layout& layout, const Word& word) {
  std::vector<std::int64_t> fields;
  for (const model::Field& field : layout.fields) fields.push_back(model::field_value(word, field));
  return fields;
}

TEST(LightTops, GiveTheWordsOfTheKernels) {
  const auto engine = model::make_lighting_engine(F::config());
  auto lights = std::make_unique<LightTable<F>>();
  auto materials = std::make_unique<MaterialTable<F>>();
  int compared = 0;
  for (const model::LightingFrame& frame : model::lighting_frames(F::config(), 4)) {
    std::vector<std::vector<std::vector<std::int64_t>>> streams;
    engine->capture(frame, [&](const model::Layout& layout, const Word* words, std::size_t count) {
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

TEST(LightTops, SelectAndSetUpAsTheKernels) {
  const model::Configuration configuration(F::config().name, F::config());
  const auto engine = model::make_engine(configuration, F::kLanes);
  std::size_t selected = 0, set_up = 0, dropped = 0;
  for (model::NamedFrame& frame : model::random_frames(model::raster_format(configuration), 5, 12, 60)) {
    engine->light(model::awkward_normals(frame.scene.triangles.size(), F::config(), 5));
    std::map<std::string, std::vector<std::vector<std::int64_t>>> streams;
    engine->capture(frame.scene, [&](const model::Layout& layout, const Word* words, std::size_t count) {
      if (layout.head_bits != layout.bits) return;  // with lanes
      auto& stream = streams[layout.stream];
      for (std::size_t n = 0; n < count; ++n) stream.push_back(fields_of(layout, words[n]));
    });
    ASSERT_EQ(streams["attributes"].size(), streams["visible"].size());
    std::size_t passed = 0, lit = 0;
    for (std::size_t n = 0; n < streams["visible"].size(); ++n) {
      std::vector<std::int64_t> told(kVisibleFields, -1), out(kAttributesFields, -1);
      const bool sent =
          visible_select_top(streams["attributes"][n].data(), streams["visible"][n].data(), told.data(), out.data());
      ASSERT_EQ(told, streams["visible"][n]);
      if (!sent) {
        ++dropped;
        continue;
      }
      ASSERT_EQ(out, streams["visible_attributes"].at(passed)) << frame.note;
      if (out[1] == 0) {  // not empty
        std::vector<std::int64_t> planes(kPlanesFields, -1);
        shade_setup_lit_top(out.data(), streams["colours"].at(lit++).data(), planes.data());
        ASSERT_EQ(planes, streams["planes"].at(passed)) << frame.note;
        ++set_up;
      }
      ++passed, ++selected;
    }
    ASSERT_EQ(passed, streams["planes"].size());
    ASSERT_EQ(lit, streams["normals"].size());
  }
  EXPECT_GT(selected, 50u);
  EXPECT_GT(set_up, 50u);
  EXPECT_GT(dropped, 50u);
}

}  // namespace
}  // namespace halfspace::tests
