// SPDX-License-Identifier: Apache-2.0
// Kernels against the floating-point reference on whole frames. The bounds, in LSB of what is stored:
//   coverage   0: both are exact
//   colour     1 of 8 bits: the plane is off by less than 1/16, and rounding both sides makes 1 of it at most
//   depth      1: the plane is off by less than 0.39
//   index      where two depths are less than an LSB apart the nearer triangle may be the other one
#include <gtest/gtest.h>

#include "model/pipeline/engine.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/scene/scene.hpp"
#include "study/trade/accuracy.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

using model::Accuracy;

ref::SnappedList frame_of(const std::string& scene, const std::string& config, int width, int height) {
  const ref::RasterFormat format = model::raster_format(config);
  return ref::snap(ref::project(ref::load_scene(scene), {width, height, format.range_bits, format.subpixel_bits}),
                   format);
}

// Renders with both and holds the bounds. Returns what was measured.
Accuracy expect_agreement(const ref::SnappedList& scene, int lanes, double index_share) {
  const ref::Frame reference = ref::render(scene);
  const ref::Frame kernels = model::make_engine(scene.format.name, lanes)->render(scene);
  const Accuracy a = model::accuracy(reference, kernels, scene.format.depth_bits);
  EXPECT_EQ(a.covered_differ, 0u);
  EXPECT_LE(a.depth_largest, 1);
  EXPECT_LE(a.colour_largest, 1);
  EXPECT_LE(double(a.index_differ), index_share * double(a.pixels));
  return a;
}

void expect_scene(const std::string& scene, const std::string& config, int width, int height) {
  SCOPED_TRACE(scene + " " + config);
  // 16 bits of depth decide otherwise now and then where surfaces touch; 24 do not.
  const Accuracy a = expect_agreement(frame_of(scene, config, width, height), 16, config == "low" ? 1e-3 : 1e-4);
  EXPECT_GT(a.compared, 0u);
  std::printf(
      "%-10s %-7s %8llu pixels shown, index differs in %llu, depth %lld LSB (in %llu), colour %lld LSB (in %llu)\n",
      scene.c_str(), config.c_str(), static_cast<unsigned long long>(a.compared),
      static_cast<unsigned long long>(a.index_differ), static_cast<long long>(a.depth_largest),
      static_cast<unsigned long long>(a.depth_differ), static_cast<long long>(a.colour_largest),
      static_cast<unsigned long long>(a.colour_differ));
}

TEST(Agreement, OfEveryBuiltInScene) {
  for (const std::string& scene : ref::builtin_scene_names()) {
    expect_scene(scene, "low", 320, 200);
    expect_scene(scene, "middle", 640, 480);
  }
  expect_scene("teapot", "high", 1920, 1080);
  expect_scene("castle", "high", 1920, 1080);
}

TEST(Agreement, OfSceneFiles) {
  const std::string models = HALFSPACE_TESTMODELS;
  expect_scene(models + "/OBJ/spider.obj", "middle", 640, 480);
  // 54,840 triangles face the viewer: more than middle takes.
  expect_scene(models + "/glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", "high", 640, 480);
}

// The corner cases and random frames: depths are random here, so that many triangles meet.
TEST(Agreement, OfTheStandardSet) {
  for (const char* config : {"low", "middle", "high"}) {
    const ref::RasterFormat format = model::raster_format(config);
    std::vector<model::NamedFrame> frames = model::corner_frames(format);
    for (auto& frame : model::random_frames(format, 9, 20, 80)) frames.push_back(std::move(frame));
    for (const model::NamedFrame& frame : frames) {
      SCOPED_TRACE(config + (": " + frame.note));
      expect_agreement(frame.scene, 4, 0.02);
    }
  }
}

// The picture does not depend on the stamp, and a second frame not on the first.
TEST(Agreement, OfAllStampsAndOfTwoFrames) {
  const ref::SnappedList scene = frame_of("castle", "middle", 333, 251);
  const ref::SnappedList other = frame_of("teapot", "middle", 120, 90);
  const ref::Frame first = model::make_engine("middle", 1)->render(scene);
  for (const int lanes : {2, 4, 8, 16}) {
    const auto engine = model::make_engine("middle", lanes);
    engine->render(other);
    const ref::Frame frame = engine->render(scene);
    EXPECT_EQ(frame.index, first.index) << lanes << " lanes";
    EXPECT_EQ(frame.depth, first.depth) << lanes << " lanes";
    EXPECT_EQ(frame.colour, first.colour) << lanes << " lanes";
    EXPECT_EQ(frame.visible, first.visible) << lanes << " lanes";
  }
}

// A triangle is reported visible exactly when the reference says that a fragment of it passed.
TEST(Agreement, OfTheVisibleFlags) {
  const ref::SnappedList scene = frame_of("castle", "high", 640, 480);
  const ref::Frame reference = ref::render(scene);
  const ref::Frame kernels = model::make_engine("high", 4)->render(scene);
  std::size_t differ = 0, visible = 0;
  for (std::size_t k = 0; k < reference.visible.size(); ++k) {
    differ += reference.visible[k] != kernels.visible[k];
    visible += reference.visible[k];
  }
  EXPECT_GT(visible, 100u);
  EXPECT_LT(visible, reference.visible.size()) << "the castle hides some of its triangles";
  EXPECT_LE(differ, reference.visible.size() / 500);
}

TEST(Agreement, OfEqualDepthsIsExact) {
  const ref::RasterFormat format = model::raster_format("high");
  ref::SnappedList scene{format, 200, 100, {0, 0, 0}, {}};
  for (const std::uint32_t depth : {0u, 1u, 0x555555u, 0xfffffeu}) {
    scene.triangles = {{{-2000000, 1999999, 70}, {3, 40000, 17}, {depth, depth, depth}, {}}};
    const ref::Frame frame = model::make_engine("high", 1)->render(scene);
    std::size_t covered = 0;
    for (std::size_t n = 0; n < frame.index.size(); ++n) {
      if (frame.index[n] == 0) continue;
      ++covered;
      ASSERT_EQ(frame.depth[n], depth);
    }
    EXPECT_GT(covered, 0u);
  }
}

}  // namespace
}  // namespace halfspace::tests
