// SPDX-License-Identifier: Apache-2.0
// Configurations with texture, textures fitted to their memory, and coordinates in their bits.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/scene/scene.hpp"
#include "tests/config_path.hpp"
#include "tests/texture/textured_configs.hpp"

namespace halfspace::tests {
namespace {

TEST(TextureConfigurations, FilesAndHeadersAgree) {
  for (const Config& config : {TexturedLow::config(), TexturedMiddle::config(), TexturedHigh::config(),
                               TexturedFlat::config(), TexturedPhong::config()}) {
    const std::string path = config_path(config.name);
    EXPECT_EQ(model::configuration_toml(model::find_configuration(path)),
              model::configuration_toml(configuration_of(config)));
    EXPECT_TRUE(model::same_numbers(model::find_configuration(path).config(), config)) << config.name;
    EXPECT_NE(model::configuration_header(configuration_of(config)).find(", TextureFilter::k"), std::string::npos);
  }
}

TEST(TextureConfigurations, AreRefusedWithAReason) {
  const auto refusal_of = [](auto change) { return halfspace::refusal_of(TexturedHigh::config(), change); };
  const auto says = [&](auto change, const char* what) {
    EXPECT_NE(refusal_of(change).find(what), std::string::npos) << refusal_of(change);
  };
  EXPECT_EQ(refusal_of([](Config&) {}), "accepted");
  says([](Config& c) { c.coordinate_bits = 25; }, "coordinate_bits is 10 to 24");
  says([](Config& c) { c.texels = 3000; }, "texels is a power of two");
  says([](Config& c) { c.texels = 1 << 21; }, "texels is a power of two, 4 to 1048576");
  says([](Config& c) { c.textures = 0; }, "textures is 1 to 256");
  says([](Config& c) { c.coordinate_fraction = 0; }, "coordinate_fraction are 1 to 40");
  says([](Config& c) { c.coordinate_fraction = 14; }, "planes of texture coordinates can be off");
  says([](Config& c) { c.coordinate_fraction = 21; }, "more fraction bits than its reciprocal");
  says([](Config& c) { c.texture = TextureFilter::kNone; }, "where texture is \"none\"");
  says(
      [](Config& c) {
        const Config plain = model::find_configuration("high").config();
        c = plain, c.mapping = TextureMapping::kPerspective;
      },
      "where texture is \"none\"");
}

// As the memory has room: powers of two, the largest halved first; a picture that fits is as it was.
TEST(Textures, AreFittedToTheMemory) {
  const auto texture = [](const char* name, int width, int height) {
    return ref::Texture{name, width, height,
                        std::vector<std::array<std::uint8_t, 3>>(std::size_t(width) * height, {9, 99, 199})};
  };
  ref::Scene scene;
  scene.name = "scene";
  scene.textures = {texture("large", 64, 64), texture("odd", 33, 17), texture("narrow", 1, 8)};
  const Config low = TexturedLow::config(), middle = TexturedMiddle::config();
  ref::Scene in_low = scene, in_middle = scene;
  const auto warnings = model::fit_textures(in_low, low);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0],
            "large: 64x64 texels are scaled to 32x32: configuration textured_low has 4096 texels, and sides of powers "
            "of two");
  EXPECT_NE(warnings[1].find("odd: 33x17 texels are scaled to 32x16"), std::string::npos);
  EXPECT_EQ(in_low.textures[2].width, 1);
  for (const ref::Texture& t : in_low.textures) EXPECT_EQ(t.texels, texture("", t.width, t.height).texels);
  ASSERT_EQ(model::fit_textures(in_middle, middle).size(), 1u);
  EXPECT_EQ(in_middle.textures[0].width, 64);
  EXPECT_EQ(in_middle.textures[2].width, 2) << "a bilinear filter has two banks each way";
  const model::TextureFrame frame = model::loaded_textures(in_middle.textures, middle);
  for (const model::RawTexture& t : frame.textures) EXPECT_EQ(t.base % (1 << (t.log2_width + t.log2_height)), 0);
  std::vector<int> seen(4096 + 512 + 16);
  for (const model::RawTexel& texel : frame.texels) ++seen.at(std::size_t(texel.address));
  EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
  scene.textures.assign(17, texture("small", 4, 4));
  EXPECT_THROW(model::fit_textures(scene, low), ref::Error);
}

TEST(Coordinates, AreQuantized) {
  const Config config = TexturedMiddle::config();
  const int full = (1 << 24) - 1;
  const auto words = model::quantized_coordinates({{{5, -2}, {6.5, -2}, {5, 0}}}, {1, 2, 1e9}, config, "here");
  EXPECT_EQ(words.repeats, 1);
  EXPECT_EQ(words.q, (std::array<int, 3>{full, 1 << 23, 1}));
  EXPECT_EQ(words.s, (std::array<int, 3>{0, 3 << 21, 0}));
  EXPECT_EQ(words.t, (std::array<int, 3>{0, 0, 1}));
  const auto affine =
      model::quantized_coordinates({{{0, 0}, {0.5, 1}, {1, 0.25}}}, {1, 2, 3}, TexturedLow::config(), "here");
  EXPECT_EQ(affine.repeats, 0);
  EXPECT_EQ(affine.s, (std::array<int, 3>{0, 1 << 15, (1 << 16) - 1}));
  EXPECT_EQ(affine.q, (std::array<int, 3>{0, 0, 0}));
  EXPECT_EQ(model::quantized_coordinates({{{0, 0}, {32768, 1}, {0, 0}}}, {1, 1, 1}, config, "here").repeats, 15);
  try {
    model::quantized_coordinates({{{0, 0}, {32769, 1}, {0, 0}}}, {1, 1, 1}, config, "scene: triangle 7");
    ADD_FAILURE();
  } catch (const ref::Error& e) {
    EXPECT_NE(std::string(e.what()).find("scene: triangle 7 spans 32769 repetitions"), std::string::npos);
  }
}

}  // namespace
}  // namespace halfspace::tests
