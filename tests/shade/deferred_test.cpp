// SPDX-License-Identifier: Apache-2.0
// Deferred lighting in the kernels: it loses nothing, lights what is visible alone, and sets indices free.
#include <gtest/gtest.h>

#include <cstdio>

#include "model/formats/field_value.hpp"
#include "model/pipeline/engine.hpp"
#include "model/shade/frame_lighting.hpp"
#include "ref/error.hpp"
#include "ref/scene/scene.hpp"
#include "tests/config_path.hpp"
#include "tests/shade/lit_configs.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/frames/frame_builder.hpp"

namespace halfspace::tests {
namespace {

// The same formats, and triangles that come with their colours.
Config unlit(Config config) {
  config.normal_bits = config.lights = config.gloss = config.materials = 0;
  return config;
}

// How many words of a stream of a frame have `field` set; all words if it is null.
std::size_t count(model::Engine& engine, const ref::SnappedList& list, const std::string& stream, const char* field) {
  std::size_t found = 0;
  engine.capture(list, [&](const model::Layout& layout, const model::Word* words, std::size_t n) {
    if (layout.stream != stream) return;
    found += field ? model::count_set(layout, words, n, field) : n;
  });
  return found;
}

class DeferredLighting : public testing::TestWithParam<Config> {};

TEST_P(DeferredLighting, DrawsThePictureOfTrianglesThatWereLitBefore) {
  Config config = GetParam();
  config.materials = 512;  // castle has 384
  config.triangles = 4096;
  std::size_t hidden = 0;
  const auto deferred = model::make_engine(configuration_of(config), 4);
  const auto at_once = model::make_engine(configuration_of(unlit(config)), 4);
  const auto lighting = model::make_lighting_engine(config);
  for (const std::string& name : ref::builtin_scene_names()) {
    const ref::Scene scene = ref::load_scene(name);
    const int width = std::min(config.width, 320), height = std::min(config.height, 200);
    const ref::Geometry geometry(scene, {width, height, config.range_bits, config.subpixel_bits});
    ref::SnappedList list = ref::snap(geometry.positions(), model::raster_format(configuration_of(config)));
    const model::LightingFrame frame = model::frame_lighting(geometry, config);
    deferred->light(frame);
    const ref::Frame got = deferred->render(list);
    const std::size_t lit = count(*deferred, list, "normals", nullptr);

    const auto colours = lighting->colours(frame);
    for (std::size_t k = 0; k < list.triangles.size(); ++k) {
      for (int v = 0; v < 3; ++v) {
        for (int c = 0; c < 3; ++c) list.triangles[k].rgb[v][c] = std::uint8_t(colours[k][v][c]);
      }
    }
    const ref::Frame want = at_once->render(list);
    EXPECT_EQ(got.colour, want.colour) << config.name << ", " << name;
    EXPECT_EQ(got.index, want.index) << config.name << ", " << name;
    EXPECT_EQ(lit, count(*at_once, list, "visible", "visible")) << config.name << ", " << name;
    hidden += list.triangles.size() - lit;
    std::printf("%-10s %-12s %zu of %zu triangles lit\n", config.name, name.c_str(), lit, list.triangles.size());
  }
  EXPECT_GT(hidden, 500u) << "nothing is hidden, and the test shows nothing";
}

INSTANTIATE_TEST_SUITE_P(Configurations, DeferredLighting,
                         testing::Values(LitLow::config(), LitMiddle::config(), LitMatte::config()),
                         [](const auto& info) { return info.param.name; });

// 40 visible triangles side by side, before each of them 25 that an earlier, nearer one hides.
ref::SnappedList crowd(const ref::RasterFormat& format) {
  model::FrameBuilder b(format, 60, 40);
  const int one = b.one();
  b.add({0, 0}, {20 * one, 0}, {0, 20 * one}).depth(1);
  for (int n = 1; n <= 1000; ++n) {
    if (n % 25 != 0) {
      b.add({2 * one, 2 * one}, {6 * one, 2 * one}, {2 * one, (4 + n % 5) * one}).depth(b.full_depth() / 2);
      continue;
    }
    const int x = (22 + n / 25 % 10 * 3) * one, y = n / 250 * 3 * one;
    b.add({x, y}, {x + 3 * one, y}, {x, y + 3 * one}).depth(b.full_depth() / 3);
  }
  return b.list();
}

// As many indices as triangles are visible, and a window of them: the picture of a frame with an index for each
// triangle.
void expect_reuse(Config config, int window) {
  config.triangles = 2000;
  ref::RasterFormat format = model::raster_format(configuration_of(config));
  const ref::SnappedList list = crowd(format);
  model::LightingFrame normals;
  if (has_lighting(config)) normals = model::awkward_normals(list.triangles.size(), config, 7);
  const auto large = model::make_engine(configuration_of(config), 4);
  if (has_lighting(config)) large->light(normals);
  const ref::Frame want = large->render(list);
  std::size_t visible = 0;
  for (const bool one : want.visible) visible += one;
  ASSERT_EQ(visible, 41u);

  config.triangles = int(visible) + window;
  const auto small = model::make_engine(configuration_of(config), 4);
  if (has_lighting(config)) small->light(normals);
  EXPECT_THROW(small->render(list), ref::Error);
  small->reuse_indices(window);
  EXPECT_EQ(small->render(list).colour, want.colour) << config.name << ", window " << window;

  config.triangles = int(visible) - 1;
  const auto tiny = model::make_engine(configuration_of(config), 4);
  if (has_lighting(config)) tiny->light(normals);
  tiny->reuse_indices(window);
  EXPECT_THROW(tiny->render(list), ref::Error) << "more are visible than there are indices";
}

TEST(IndexReuse, DrawsMoreTrianglesThanThereAreIndices) {
  for (const int window : {1, 8, 200}) {
    expect_reuse(LitLow::config(), window);
    expect_reuse(unlit(LitLow::config()), window);
    expect_reuse(LitMiddle::config(), window);
    expect_reuse(PhongLow::config(), window);
    Config gamma = LitLow::config();
    gamma.architecture = Architecture::kGamma;
    expect_reuse(gamma, window);
  }
}

}  // namespace
}  // namespace halfspace::tests
