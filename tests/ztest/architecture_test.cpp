// SPDX-License-Identifier: Apache-2.0
// The four architectures draw one picture, and deferring the lighting or using an index twice changes none of it.
#include "ref/raster/architecture.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/raster/raster.hpp"

namespace {

using namespace halfspace;
using ref::Architecture;
using ref::ShadingMode;

struct Frame {
  std::string scene;
  int width, height;
};

const std::vector<Frame>& frames() {
  static const std::vector<Frame> all = [] {
    std::vector<Frame> list;
    std::vector<std::string> scenes = ref::builtin_scene_names();
    for (const char* file : {"OBJ/spider.obj", "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", "PLY/cube.ply",
                             "Collada/duck.dae", "X/test.x"}) {
      scenes.push_back(std::string(HALFSPACE_TESTMODELS "/") + file);
    }
    for (const std::string& scene : scenes) {
      list.push_back({scene, 320, 200});
      list.push_back({scene, 200, 150});
    }
    return list;
  }();
  return all;
}

class Architectures : public ::testing::TestWithParam<Frame> {
 protected:
  void SetUp() override {
    format_ = model::raster_format("high");
    scene_ = ref::load_scene(GetParam().scene);
    view_ = {GetParam().width, GetParam().height, format_.range_bits, format_.subpixel_bits};
  }
  ref::Drawing draw(Architecture architecture, ShadingMode mode, bool deferred = true,
                    const ref::IndexReuse& reuse = {}) {
    ref::Geometry geometry(scene_, view_);
    const ref::SnappedList list = ref::snap(geometry.positions(), format_);
    const auto surface = ref::lit_surface(geometry, list, mode);
    return ref::draw(list, *surface, architecture, deferred, reuse);
  }
  ref::RasterFormat format_;
  ref::Scene scene_;
  ref::View view_{};
};

TEST_P(Architectures, DrawOnePicture) {
  ref::SnappedList lit = ref::snap(ref::project(scene_, view_), format_);
  for (const ShadingMode mode : ref::kShadingModes) {
    SCOPED_TRACE(name_of(mode));
    const ref::Drawing delta = draw(Architecture::kDelta, mode);
    ASSERT_GT(delta.rates.visible_pixels, 100u);
    lit.format.flat = mode == ShadingMode::kFlat;
    const ref::Frame frame = ref::render(lit);
    EXPECT_EQ(delta.triangle, frame.index);
    EXPECT_EQ(delta.depth, frame.depth);
    EXPECT_EQ(delta.visible, frame.visible);
    if (mode != ShadingMode::kPhong) {
      EXPECT_EQ(delta.colour, frame.colour);
    }
    for (const Architecture architecture : ref::kArchitectures) {
      SCOPED_TRACE(name_of(architecture));
      const ref::Drawing other = draw(architecture, mode);
      EXPECT_EQ(other.triangle, delta.triangle);
      EXPECT_EQ(other.depth, delta.depth);
      EXPECT_EQ(other.colour, delta.colour);
      EXPECT_EQ(other.rates.fragments, delta.rates.fragments);
      EXPECT_EQ(other.rates.reduced_fragments, delta.rates.reduced_fragments);
      EXPECT_EQ(other.rates.reduced_triangles, delta.rates.reduced_triangles);
      EXPECT_EQ(other.rates.visible_pixels, delta.rates.visible_pixels);
    }
  }
}

// By an independent count: which triangles the reference rasterizer found visible.
TEST_P(Architectures, LightWhatTheDataRatesSay) {
  const ref::Frame frame = ref::render(ref::snap(ref::project(scene_, view_), format_));
  std::uint64_t reduced = 0, seen = 0;
  for (const bool visible : frame.visible) reduced += visible;
  for (const std::uint32_t index : frame.index) seen += index != 0;
  const std::uint64_t triangles = frame.visible.size();
  for (const ShadingMode mode : ref::kShadingModes) {
    SCOPED_TRACE(name_of(mode));
    const std::uint64_t each = mode == ShadingMode::kFlat ? 1 : 3;
    const ref::Drawing alpha = draw(Architecture::kAlpha, mode), beta = draw(Architecture::kBeta, mode);
    if (mode == ShadingMode::kPhong) {
      EXPECT_EQ(alpha.rates.lightings, alpha.rates.reduced_fragments);
      EXPECT_EQ(beta.rates.lightings, seen);
    } else {
      EXPECT_EQ(alpha.rates.lightings, each * triangles);
      EXPECT_EQ(beta.rates.lightings, each * triangles);
    }
    for (const Architecture architecture : {Architecture::kGamma, Architecture::kDelta}) {
      const ref::Drawing deferred = draw(architecture, mode), not_deferred = draw(architecture, mode, false);
      EXPECT_EQ(deferred.colour, not_deferred.colour);
      if (mode == ShadingMode::kPhong) {
        EXPECT_EQ(deferred.rates.lightings, seen);
      } else {
        EXPECT_EQ(deferred.rates.lightings, each * reduced);
        EXPECT_EQ(not_deferred.rates.lightings, each * triangles);
      }
    }
  }
}

TEST_P(Architectures, UseAnIndexAgain) {
  const ref::Drawing once = draw(Architecture::kDelta, ShadingMode::kGouraud);
  EXPECT_EQ(once.rates.largest_index, once.rates.triangles);
  for (const std::uint32_t window : {1u, 7u, 64u}) {
    for (const Architecture architecture : {Architecture::kGamma, Architecture::kDelta}) {
      const ref::Drawing again = draw(architecture, ShadingMode::kGouraud, true, {window});
      EXPECT_EQ(again.triangle, once.triangle);
      EXPECT_EQ(again.colour, once.colour);
      EXPECT_GE(again.rates.largest_index, again.rates.reduced_triangles);
      EXPECT_LE(again.rates.largest_index, again.rates.reduced_triangles + window);
    }
  }
}

std::string title(const ::testing::TestParamInfo<Frame>& info) {
  std::string name = info.param.scene.substr(info.param.scene.rfind('/') + 1);
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name + "_" + std::to_string(info.param.width);
}
INSTANTIATE_TEST_SUITE_P(Scenes, Architectures, ::testing::ValuesIn(frames()), title);

// More triangles than there are index values, fewer of them visible.
TEST(IndexReuse, DrawsMoreTrianglesThanThereAreIndices) {
  ref::TriangleList list{64, 48, {}, {}, {}};
  list.triangles.push_back({{{0, 0, 0.1, 250, 0, 0}, {0, 200, 0.1, 250, 0, 0}, {200, 0, 0.1, 250, 0, 0}}});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 48);
  for (int n = 0; n < 1000; ++n) {
    const double z = n % 100 == 99 ? 0.09 - n * 1e-5 : 0.5;  // one of a hundred is in front
    list.triangles.push_back({{{place(random), place(random), z, 0, 250, 0},
                               {place(random), place(random), z, 0, 250, 0},
                               {place(random), place(random), z, 0, 250, 0}}});
  }
  const ref::SnappedList snapped = ref::snap(list, model::raster_format("middle"));
  const auto surface = ref::given_surface(snapped);
  const ref::Frame expected = ref::render(snapped);
  const ref::Drawing drawing = ref::draw(snapped, *surface, Architecture::kGamma, true, {4, 15});
  EXPECT_EQ(drawing.triangle, expected.index);
  EXPECT_EQ(drawing.colour, expected.colour);
  EXPECT_LE(drawing.rates.largest_index, 15u);
  EXPECT_THROW(ref::draw(snapped, *surface, Architecture::kGamma, true, {4, 10}), ref::Error);
  EXPECT_THROW(ref::draw(snapped, *surface, Architecture::kGamma, true, {0, 15}), ref::Error);
}

}  // namespace
