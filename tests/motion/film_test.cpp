// SPDX-License-Identifier: Apache-2.0
// A film of one design, passes and all, on the animations that stand for the paper's: its frames are those that two
// designs make, which shade every pixel of a frame in between to fill its holes.
#include <gtest/gtest.h>

#include <set>

#include "model/drivers/film.hpp"
#include "model/drivers/up_convert.hpp"
#include "model/texture/texture.hpp"
#include "ref/builtin/animated_scenes.hpp"
#include "ref/error.hpp"
#include "ref/motion/quality.hpp"
#include "tests/config_path.hpp"

namespace halfspace {
namespace {

using model::Configuration;

struct Kind {
  const char* config;
  int width, height, intervals;
};

std::vector<ref::Scene> scenes_of(const std::string& name, int frames, const Config& config) {
  std::vector<ref::Scene> scenes;
  for (int n = 0; n < frames; ++n) {
    scenes.push_back(ref::load_scene(name, (5 + 3 * n) / 30.0, {has_texture(config)}));
    if (has_texture(config)) model::fit_textures(scenes.back(), config);
  }
  return scenes;
}

class Film : public testing::TestWithParam<Kind> {};

TEST_P(Film, IsThatOfTwoDesigns) {
  const Kind& kind = GetParam();
  const Configuration configuration = model::find_configuration(config_path(kind.config));
  const Config config = configuration.config();
  const int step = config.frames_between + 1;
  std::size_t filled = 0, asked = 0, background = 0;
  for (const std::string& name : ref::animated_scene_names()) {
    SCOPED_TRACE(name);
    const std::vector<ref::Scene> scenes = scenes_of(name, kind.intervals * step + 1, config);
    std::vector<ref::Colours> shown;
    std::vector<model::FilmDrawn> fields, fills;
    model::FilmMaker maker(
        configuration, kind.width, kind.height, 4, [&](const model::FilmPass& pass, const model::FilmDrawn& drawn) {
          for (const auto& frame : drawn.shown) shown.push_back(frame);
          if (pass.pass == Pass::kBetween) fields.push_back(drawn), fills.emplace_back();
          if (pass.pass != Pass::kFill) return;
          fills.back() = drawn;
          const std::set<std::uint32_t> wanted(fields.back().asked.begin(), fields.back().asked.end());
          EXPECT_EQ(std::set<std::uint32_t>(pass.faces.begin(), pass.faces.end()), wanted);
        });
    model::KernelUpConverter two({kind.width, kind.height, model::key_part(configuration),
                                  model::between_part(configuration), ref::MotionMethod::kExact, false, 4});
    maker.begin(scenes[0]);
    for (int j = 0; j < kind.intervals; ++j) {
      const auto at = scenes.begin() + j * step;
      maker.add(at[step], {at + 1, at + step});
      two.set_keys(at[0], at[step]);
      ASSERT_EQ(shown.size(), std::size_t((j + 1) * step + 1));
      EXPECT_EQ(shown[std::size_t(j * step)], two.key_colour(0));
      EXPECT_EQ(shown.back(), two.key_colour(1));
      for (int i = 1; i < step; ++i) {
        const model::KernelFrameBetween made = two.at(at[i], double(i) / step);
        const std::size_t field = std::size_t(j * (step - 1) + i - 1);
        EXPECT_EQ(shown[std::size_t(j * step + i)], made.colour) << "frame " << i << " of interval " << j;
        EXPECT_EQ(fields[field].holes, made.shares.filled);
        EXPECT_EQ(fills[field].filled, made.shares.filled);
        EXPECT_EQ(fields[field].asked.empty(), made.shares.filled == 0);
        EXPECT_LE(fields[field].asked.size(), made.shares.filled);
        filled += made.shares.filled, asked += fields[field].asked.size(), background += made.shares.background;
      }
    }
  }
  RecordProperty("filled", int(filled));
  RecordProperty("asked", int(asked));
  EXPECT_GT(filled, 50u);
  EXPECT_LT(asked, filled);
  EXPECT_GT(background, filled);
}

INSTANTIATE_TEST_SUITE_P(Of, Film,
                         testing::Values(Kind{"film_tiny", 53, 37, 2}, Kind{"film_middle", 48, 36, 1},
                                         Kind{"film_phong", 48, 36, 2}, Kind{"film_textured", 48, 36, 1}),
                         [](const auto& info) { return info.param.config; });

TEST(FilmPasses, GoInTheirOrder) {
  const Configuration configuration = model::find_configuration(config_path("film_tiny"));
  const std::vector<ref::Scene> scenes = scenes_of("cube_fast", 3, configuration.config());
  const std::vector<model::FilmPass> passes = model::film_passes(configuration, 40, 30, 4, scenes);
  ASSERT_GE(passes.size(), 3u);
  const auto engine = model::make_film_engine(configuration, 4);
  EXPECT_THROW(engine->run(passes[1]), ref::Error);
  engine->run(passes[0]);
  EXPECT_THROW(engine->run(passes[0]), ref::Error);
  EXPECT_THROW(engine->run(passes[2]), ref::Error);
  engine->run(passes[1]);
  engine->run(passes[2]);
  EXPECT_THROW(model::film_passes(configuration, 40, 30, 4, {scenes[0], scenes[1]}), ref::Error);
  EXPECT_THROW(model::make_film_engine(model::find_configuration("low"), 4), ref::Error);
}

}  // namespace
}  // namespace halfspace
