// SPDX-License-Identifier: Apache-2.0
// A triangle that the setup culls is one that geometry leaves out: the same picture, and the same words behind it but
// for indices. Reference, kernels and the model of cycles count the same ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "model/formats/field_value.hpp"
#include "model/pipeline/cycles.hpp"
#include "model/pipeline/engine.hpp"
#include "model/pipeline/rates.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/geometry/surface.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

model::Configuration culling(const std::string& name, Cull which, int window = 0) {
  Config config = model::find_configuration(name).config();
  config.cull = which;
  config.index_window = window;
  config.triangles = 20000;
  return {"culling", config};
}

ref::SnappedList list_of(const ref::Scene& scene, const model::Configuration& configuration) {
  ref::RasterFormat format = model::raster_format(configuration);
  format.triangles = 1 << 20;
  return ref::snap(ref::project(scene, ref::frame_view(format, 160, 120)), format);
}

// Of a scene whose materials show their faces from one side.
ref::Scene one_sided(const std::string& name) {
  ref::Scene scene = ref::load_scene(name);
  for (ref::Material& material : scene.materials) material.two_sided = false;
  return scene;
}

// The words of triangles that are not empty, or of what covers a pixel; indices, and which word is the last of the
// frame, are those of other triangles.
using Words = std::map<std::string, std::vector<std::vector<std::int64_t>>>;
Words drawn_words(model::Engine& engine, const ref::SnappedList& list) {
  Words all;
  engine.capture(list, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
    if (layout.stream != "setup" && layout.stream != "stamp" && layout.stream != "planes" && layout.stream != "update")
      return;
    for (std::size_t n = 0; n < count; ++n) {
      std::vector<std::int64_t> values;
      bool draws = true, covers = false, has_mask = false;
      for (const model::Field& field : layout.fields) {
        for (int lane = 0; lane < field.count; ++lane) {
          const std::int64_t value = model::field_value(words[n], field, lane);
          if (field.name == "empty") draws = value == 0;
          if (field.name == "mask") has_mask = true, covers = covers || value != 0;
          if (field.name != "index" && field.name != "last") values.push_back(value);
        }
      }
      if (draws && (covers || !has_mask)) all[layout.stream].push_back(values);
    }
  });
  return all;
}

TEST(Cull, DrawsWhatGeometryWouldHaveLeft) {
  for (const char* name : {"low", "tests/configs/base/gamma.toml", "tests/configs/base/flat_only.toml"}) {
    const std::string config = name[0] == 't' ? std::string(HALFSPACE_SOURCE "/") + name : name;
    for (const char* scene_name : {"castle", "teapot"}) {
      const ref::Scene scene = one_sided(scene_name);
      const ref::SnappedList left = list_of(scene, culling(config, Cull::kNone));
      for (const int window : {0, 40}) {
        const auto geometry = model::make_engine(culling(config, Cull::kNone, window), 4);
        const auto setup = model::make_engine(culling(config, Cull::kBack, window), 4);
        const ref::SnappedList all = list_of(scene, culling(config, Cull::kBack, window));
        EXPECT_GT(all.triangles.size(), left.triangles.size());
        EXPECT_EQ(setup->render(all).colour, geometry->render(left).colour) << config << " " << scene_name;
        const Words ours = drawn_words(*setup, all), theirs = drawn_words(*geometry, left);
        EXPECT_EQ(ours.size(), 4u);
        EXPECT_EQ(ours, theirs) << config << " " << scene_name;
        EXPECT_EQ(ref::render(all).colour, ref::render(left).colour);
      }
    }
  }
}

TEST(Cull, SidesShareTheTriangles) {
  const ref::RasterFormat format = model::raster_format("low");
  for (model::NamedFrame frame : model::random_frames(format, 4, 20, 60)) {
    std::vector<std::vector<bool>> drawn;
    for (const Cull which : {Cull::kBack, Cull::kFront}) {
      const model::Configuration configuration = culling("low", which);
      frame.scene.format = model::raster_format(configuration);
      const ref::Frame kernels = model::make_engine(configuration, 4)->render(frame.scene);
      EXPECT_EQ(kernels.index, ref::render(frame.scene).index);
      for (std::size_t at = 0; at < kernels.index.size(); ++at) {
        if (kernels.index[at] == 0) continue;
        const ref::SnappedTriangle& t = frame.scene.triangles[kernels.index[at] - 1];
        const std::int64_t area = (std::int64_t(t.x[1]) - t.x[0]) * (std::int64_t(t.y[2]) - t.y[0]) -
                                  (std::int64_t(t.y[1]) - t.y[0]) * (std::int64_t(t.x[2]) - t.x[0]);
        ASSERT_EQ(area < 0, which == Cull::kBack) << "the front comes counter-clockwise, as rows go downward";
      }
    }
  }
}

TEST(Cull, CountsAreTheSameInReferenceAndKernels) {
  for (const Cull which : {Cull::kNone, Cull::kBack, Cull::kFront}) {
    const model::Configuration configuration = culling("low", which);
    const ref::SnappedList list = list_of(one_sided("castle"), culling("low", Cull::kBack));
    ref::SnappedList here = list;
    here.format = model::raster_format(configuration);
    const auto engine = model::make_engine(configuration, 4);
    const auto surface = ref::given_surface(here);
    const std::uint64_t counted = ref::draw(here, *surface, ref::Architecture::kDelta).rates.culled;
    EXPECT_EQ(model::count_rates(*engine, here, configuration.config()).culled, counted);
    EXPECT_EQ(counted > 0, which != Cull::kNone);
    // Culled ones take 7 cycles, and what is drawn the whole interval.
    const model::SetupModel setup(configuration.config(), here.width, here.height);
    const model::UnitIntervals intervals = model::unit_intervals(configuration.config());
    std::uint64_t cycles = 0, by_seven = 0;
    for (const ref::SnappedTriangle& t : here.triangles) {
      const int taken = setup.cycles(t).triangle_setup;
      cycles += std::uint64_t(taken);
      by_seven += taken == 7;
      EXPECT_TRUE(taken == 3 || taken == 7 || taken == intervals.triangle_setup);
    }
    EXPECT_EQ(model::model_cycles(configuration.config(), *engine, here, engine->render(here)).triangle_setup, cycles);
    std::uint64_t flat = 0;
    for (const ref::SnappedTriangle& t : here.triangles) {
      flat += !setup.has_sign(t) && setup.cycles(t).triangle_setup == 7;
    }
    EXPECT_EQ(by_seven, counted + flat);
  }
}

}  // namespace
}  // namespace halfspace::tests
