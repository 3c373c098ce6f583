// SPDX-License-Identifier: Apache-2.0
// Type γ draws what type δ draws, in every pixel: index, depth, colour and the visible triangles.
// hls/ztest/ztest_plane.hpp has the reason. Both with formats read at run time, so that nothing but the architecture
// differs.
#include <gtest/gtest.h>

#include <random>

#include "model/formats/field_value.hpp"
#include "model/pipeline/cycles.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/scene/scene.hpp"
#include "study/fit/fit.hpp"
#include "tests/config_path.hpp"
#include "vectors/frames/extremes.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

using model::Configuration;
using model::NamedFrame;

// A configuration in both types.
class Both {
 public:
  Both(const Config& numbers, int lanes) {
    Config config = numbers;
    config.architecture = Architecture::kDelta;
    delta_ = model::make_runtime_engine(config, format_table(config), lanes);
    config.architecture = Architecture::kGamma;
    EXPECT_EQ(refusal(config), Refusal::kNone);
    gamma_ = model::make_runtime_engine(config, format_table(config), lanes);
  }

  // Returns how many pixels show a triangle.
  std::size_t expect_equal(const ref::SnappedList& scene) {
    const ref::Frame delta = delta_->render(scene), gamma = gamma_->render(scene);
    EXPECT_TRUE(delta.index == gamma.index);
    EXPECT_TRUE(delta.depth == gamma.depth);
    EXPECT_TRUE(delta.colour == gamma.colour);
    EXPECT_TRUE(delta.visible == gamma.visible);
    std::size_t shown = 0;
    for (const std::uint32_t index : gamma.index) shown += index != 0;
    return shown;
  }

 private:
  std::unique_ptr<model::Engine> delta_, gamma_;
};

Config config_of(const std::string& name) { return model::find_configuration(name).config(); }

TEST(Gamma, IsDeltaOnEveryBuiltInScene) {
  for (const auto& [config, width, height] : {std::tuple("low", 160, 120), {"low", 320, 200}, {"middle", 320, 240}}) {
    const ref::RasterFormat format = model::raster_format(config);
    Both both(config_of(config), 4);
    for (const std::string& scene : ref::builtin_scene_names()) {
      SCOPED_TRACE(scene + " " + config);
      const ref::TriangleList list =
          ref::project(ref::load_scene(scene), {width, height, format.range_bits, format.subpixel_bits});
      EXPECT_GT(both.expect_equal(ref::snap(list, format)), 1000u);
    }
  }
}

TEST(Gamma, IsDeltaOnStandardFramesAndExtremes) {
  for (const std::string name : {"low", "middle", "high"}) {
    const ref::RasterFormat format = model::raster_format(name);
    std::vector<NamedFrame> frames = model::corner_frames(format);
    for (NamedFrame& frame : model::random_frames(format, 21, 10, 80)) frames.push_back(std::move(frame));
    for (NamedFrame& frame : model::extreme_frames(format)) frames.push_back(std::move(frame));
    std::size_t shown = 0;
    for (const int lanes : {1, 4, 16}) {
      Both both(config_of(name), lanes);
      for (const NamedFrame& frame : frames) {
        SCOPED_TRACE(name + ", " + std::to_string(lanes) + " lanes: " + frame.note);
        shown += both.expect_equal(frame.scene);
      }
    }
    EXPECT_GT(shown, 100000u);
  }
}

TEST(Gamma, IsDeltaWhateverTheNumbers) {
  std::mt19937 random(29);
  auto in = [&](int low, int high) { return low + int(random() % unsigned(high - low + 1)); };
  int accepted = 0;
  for (int n = 0; n < 4000 && accepted < 60; ++n) {
    Config numbers{"random",  in(1, 300), in(1, 200), in(100, 5000), in(8, 14), in(1, 10),
                   in(2, 32), in(1, 8),   in(8, 38),  in(6, 22),     in(6, 22), 1 << in(0, 4)};
    if (in(0, 3) == 0) numbers.shading = Shading::kFlat, numbers.colour_fraction = 0;
    if (refusal(numbers) != Refusal::kNone) continue;
    ++accepted;
    const Configuration configuration("random", numbers);
    SCOPED_TRACE(model::configuration_toml(configuration));
    Both both(numbers, numbers.lanes);
    for (const NamedFrame& frame : model::random_frames(model::raster_format(configuration), n, 2, 60)) {
      both.expect_equal(frame.scene);
    }
  }
  EXPECT_EQ(accepted, 60);
}

ref::SnappedList teapot() {
  const ref::RasterFormat format = model::raster_format("low");
  return ref::snap(ref::project(ref::load_scene("teapot"), {320, 200, format.range_bits, format.subpixel_bits}),
                   format);
}

// What the equality hangs on: the planes have all their bits. With a few fraction bits less, as in a narrower TdbV,
// depths of visible pixels come out otherwise than the Z-buffer has them.
TEST(Gamma, NarrowerPlanesHaveOtherDepths) {
  Config config = config_of("low");
  config.architecture = Architecture::kGamma;
  const auto engine = model::make_runtime_engine(config, format_table(config), 1);
  struct Plane {
    std::int64_t depth, dx, dy, x, y;
  };
  std::vector<Plane> planes(config.triangles + 1);
  const ref::SnappedList scene = teapot();
  engine->capture(scene, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
    if (layout.stream != "triangle_depth") return;
    ASSERT_EQ(layout.fields.size(), 6u);
    ASSERT_EQ(count, scene.triangles.size());
    for (std::size_t n = 0; n < count; ++n) {
      const auto value = [&](int field) { return model::field_value(words[n], layout.fields[std::size_t(field)]); };
      planes[std::size_t(value(0))] = {value(3), value(4), value(5), value(1), value(2)};
    }
  });
  const ref::Frame frame = engine->render(scene);
  for (const int dropped : {0, 2, 4, 8}) {
    const auto cut = [&](std::int64_t number) { return number >> dropped << dropped; };
    std::size_t other = 0, shown = 0;
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const std::size_t at = std::size_t(y) * frame.width + x;
        if (frame.index[at] == 0) continue;
        const Plane& p = planes[frame.index[at]];
        const std::int64_t origin = p.depth - p.dx * p.x - p.dy * p.y;
        const std::int64_t depth = (cut(origin) + cut(p.dx) * x + cut(p.dy) * y) >> config.depth_fraction;
        other += (depth & ((1 << config.depth_bits) - 1)) != frame.depth[at];
        ++shown;
      }
    }
    std::printf("%d fraction bits dropped: depth differs in %zu of %zu pixels\n", dropped, other, shown);
    if (dropped == 0) EXPECT_EQ(other, 0u);
    else EXPECT_GT(other, shown / 100);
  }
}

// A frame of one stamp: what the cycles and the traffic are counted from.
TEST(Gamma, TestsCostACycleForEachStoredTriangle) {
  Config config = config_of("low");
  config.architecture = Architecture::kGamma;
  const auto engine = model::make_runtime_engine(config, format_table(config), 4);
  const int one = 1 << config.subpixel_bits;
  const auto whole = [&](std::uint32_t depth) {
    ref::SnappedTriangle t{};
    t.x = {-8 * one, 24 * one, -8 * one}, t.y = {-8 * one, -8 * one, 24 * one};
    t.depth = {depth, depth, depth};
    return t;
  };
  const ref::SnappedList scene{
      model::raster_format("low"), 2, 2, {0, 0, 0}, {whole(100), whole(60000), ref::SnappedTriangle{}}};
  const std::vector<PlaneTests> tests = engine->plane_tests(scene);
  ASSERT_EQ(tests.size(), 3u);
  // One for its plane, and one for its stamp: over the background, over a triangle, over nothing.
  for (const PlaneTests& test : tests) EXPECT_EQ(test.cycles, 2);
  EXPECT_EQ(tests[0].entries, 0);
  EXPECT_EQ(tests[1].entries, 1);
  EXPECT_EQ(tests[2].entries, 0);
  const ref::Frame frame = engine->render(scene);
  const model::Accesses accesses = model::count_accesses(config, *engine, scene);
  EXPECT_EQ(model::entry_bits(config).visibility, 3 * (16 + 13));
  for (const ref::BufferUses& uses : {accesses.needed, accesses.words}) {
    EXPECT_EQ(uses.visibility.read, 1u);
    EXPECT_EQ(uses.visibility.written, 1u);  // of the visible one alone
    EXPECT_EQ(uses.depth.read + uses.depth.written, 0u);
  }
  EXPECT_EQ(model::model_cycles(config, *engine, scene, frame).test, 6u);
}

TEST(Gamma, HasTdbvInThePlaceOfTheZBuffer) {
  Config config = config_of("low");
  const model::MemoryBits delta = model::memory_bits(config);
  config.architecture = Architecture::kGamma;
  const model::MemoryBits gamma = model::memory_bits(config);
  EXPECT_EQ(delta.depth, 320u * 200 * 16);
  EXPECT_EQ(delta.visibility, 0u);
  EXPECT_EQ(gamma.depth, 0u);
  EXPECT_EQ(gamma.visibility, 4096u * 3 * 29);
}

TEST(Gamma, IsRefusedWithoutDepthAndWithoutAWord) {
  const Config idle{"x", 160, 120, 500, 9, 6, 0, 8, 20, 0, 14, 4, Shading::kGouraud, Architecture::kGamma};
  EXPECT_NE(refusal_of(idle).find("computes a depth again, and there is none"), std::string::npos) << refusal_of(idle);
  Config wide{"x", 700, 500, 500, 11, 1, 32, 8, 38, 24, 21, 4};
  EXPECT_EQ(refusal_of(wide), "accepted");
  wide.architecture = Architecture::kGamma;
  EXPECT_NE(refusal_of(wide).find("lower depth_fraction"), std::string::npos) << refusal_of(wide);
  const std::string toml = model::configuration_toml(model::find_configuration("low"));
  const std::size_t line = toml.find("architecture = ");
  EXPECT_EQ(model::parse_configuration(toml.substr(0, line), "x.toml").config().architecture, Architecture::kDelta);
  try {
    model::parse_configuration(toml.substr(0, line) + "architecture = \"beta\"\n", "x.toml");
    ADD_FAILURE() << "accepted";
  } catch (const ref::Error& e) {
    EXPECT_NE(std::string(e.what()).find("x.toml:14: architecture is \"delta\" or \"gamma\""), std::string::npos)
        << e.what();
  }
}

}  // namespace
}  // namespace halfspace::tests
