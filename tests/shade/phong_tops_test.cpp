// SPDX-License-Identifier: Apache-2.0
// The top functions of Phong shading, fields as plain integers, give the words of the kernels.
#include <gtest/gtest.h>

#include <map>
#include <memory>

#include "hls/top/fields.hpp"
#include "model/formats/field_value.hpp"
#include "model/pipeline/engine.hpp"
#include "model/shade/lighting_records.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

using TopNormalDatabase = halfspace::NormalDatabase<halfspace::TopFormats>;
extern "C" void phong_setup_top(const std::int64_t*, const std::int64_t*, std::int64_t*);
extern "C" void shade_phong_top(int, const std::int64_t*, const TopNormalDatabase*,
                                const halfspace::LightTable<halfspace::TopFormats>*,
                                const halfspace::MaterialTable<halfspace::TopFormats>*, std::int64_t*);

namespace halfspace::tests {
namespace {

using F = TopFormats;
using model::Word;
using Words = std::vector<std::vector<std::int64_t>>;

TEST(PhongTops, GiveTheWordsOfTheKernels) {
  const model::Configuration configuration(F::config().name, F::config());
  const auto engine = model::make_engine(configuration, F::kLanes);
  const auto database = std::make_unique<TopNormalDatabase>();
  const auto lights = std::make_unique<LightTable<F>>();
  const auto materials = std::make_unique<MaterialTable<F>>();
  std::size_t planes = 0, pixels = 0;
  for (model::NamedFrame& frame : model::random_frames(model::raster_format(configuration), 5, 12, 60)) {
    frame.lighting = model::awkward_normals(frame.scene.triangles.size(), F::config(), 5);
    engine->light(frame.lighting);
    model::load_lights<F>(frame.lighting, *lights);
    model::load_materials<F>(frame.lighting, *materials);
    std::map<std::string, Words> streams;
    engine->capture(frame.scene, [&](const model::Layout& layout, const Word* words, std::size_t count) {
      Words& stream = streams[layout.stream];
      for (std::size_t n = 0; n < count; ++n) {
        auto& fields = stream.emplace_back();
        for (const model::Field& field : layout.fields) {
          for (int l = 0; l < field.count; ++l) fields.push_back(model::field_value(words[n], field, l));
        }
      }
    });
    std::size_t given = 0;
    ASSERT_EQ(streams["visible_attributes"].size(), streams["planes"].size());
    for (std::size_t n = 0; n < streams["planes"].size(); ++n, ++planes) {
      const auto& attributes = streams["visible_attributes"][n];
      ASSERT_EQ(int(attributes.size()), kAttributesFields);
      if (attributes[1] != 0) continue;  // empty: the last, which is not visible
      ASSERT_EQ(int(streams["normals"].at(given).size()), kNormalsFields);
      std::vector<std::int64_t> out(kNormalPlanesFields, -1);
      phong_setup_top(attributes.data(), streams["normals"][given++].data(), out.data());
      ASSERT_EQ(out, streams["planes"][n]) << frame.note << ", word " << n;
      const NormalPlanes<F> entry = read_fields<NormalPlanes<F>>(out.data());
      database->planes[raw(entry.index) - 1] = entry;
    }
    const auto& background = frame.scene.background;
    ASSERT_EQ(streams["scan"].size(), streams["pixel"].size());
    for (std::size_t n = 0; n < streams["scan"].size(); ++n, ++pixels) {
      std::vector<std::int64_t> out(kPixelFields, -1);
      shade_phong_top(background[0] << 16 | background[1] << 8 | background[2], streams["scan"][n].data(),
                      database.get(), lights.get(), materials.get(), out.data());
      ASSERT_EQ(out, streams["pixel"][n]) << frame.note << ", word " << n;
    }
  }
  EXPECT_GT(planes, 100u);
  EXPECT_GT(pixels, 1000u);
}

}  // namespace
}  // namespace halfspace::tests
