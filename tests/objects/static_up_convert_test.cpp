// SPDX-License-Identifier: Apache-2.0
// Frames between key frames with an S-buffer: pixels that stand still are the rendered ones to the bit, and those that
// move have the words and the colours of the ordinary method.
#include <gtest/gtest.h>

#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "tests/objects/static_room.hpp"

namespace halfspace {
namespace {

TEST(StaticUpConversion, IsTheRenderedFrameWhereNothingMovesAndTheOrdinaryOneElsewhere) {
  for (const char* config : {"low", "middle"}) {
    SCOPED_TRACE(config);
    Pair pair(config);
    pair.set_keys(room(0), room(1));
    for (const double a : {0.2, 0.4, 0.6, 0.8}) {
      const Pair::Both both = pair.at(room(a), a);
      EXPECT_EQ(both.with.static_instances, 3u);
      EXPECT_EQ(both.with.static_triangles != 0, a == 0.2);  // once an interval
      EXPECT_EQ(both.with.triangles, 10u);
      EXPECT_GT(both.with.shares.still, 800u);
      EXPECT_LT(both.with.words, both.ordinary.words / 2);
      EXPECT_LT(both.with.cycles, both.ordinary.cycles);
      // At equal depths the first drawn is seen; what is in no key is rendered.
      EXPECT_GT(pair.seen(kInPlaneFirst), 40);
      EXPECT_EQ(pair.seen(kInPlaneLater), 0);
      EXPECT_GT(pair.seen(kThrough), 20);
      EXPECT_LT(pair.seen(kThrough), 200);
      EXPECT_GT(pair.seen(kBehind), 10);
      EXPECT_GT(both.with.shares.filled, 20u);
    }
  }
}

TEST(StaticUpConversion, HoldsForSamplesToo) {
  Pair pair("middle", 4);
  pair.set_keys(room(0), room(1));
  const Pair::Both both = pair.at(room(0.4), 0.4);
  EXPECT_GT(both.with.shares.still, 16u * 800);
  EXPECT_LT(both.with.words, both.ordinary.words / 2);
}

TEST(StaticUpConversion, WhereAllStandsNothingIsCompensated) {
  Pair pair("low");
  pair.set_keys(room(0), room(0));
  const Pair::Both both = pair.at(room(0), 0.5);
  EXPECT_EQ(both.with.words, 0u);
  EXPECT_EQ(both.with.triangles, 0u);
  EXPECT_EQ(both.with.misses[0] + both.with.misses[1], 0u);
  EXPECT_EQ(both.with.colour, both.with.rendered);
}

TEST(StaticUpConversion, ACourtTakesFewWords) {
  const auto court = [](int n) { return ref::load_scene("court", n / 30.0); };
  Pair pair("middle");
  std::vector<Scene> times;
  for (const int n : {0, 2, 5, 70, 72, 75}) times.push_back(court(n));
  std::vector<const Scene*> all;
  for (const Scene& scene : times) all.push_back(&scene);
  const ref::DepthPlanes planes = ref::held_planes(all, kAspect);
  for (Scene& scene : times) scene.depth_planes = planes;
  pair.set_keys(times[0], times[2]);
  EXPECT_EQ(pair.at(times[1], 0.4).with.static_instances, 6u);  // the castle, and the drone but for its blades
  pair.set_keys(times[3], times[5]);
  const Pair::Both both = pair.at(times[4], 0.4);
  EXPECT_EQ(both.with.static_instances, 1u);
  EXPECT_GT(both.with.words, 20u);
  EXPECT_LT(both.with.words, both.ordinary.words / 10);
}

TEST(StaticUpConversion, TexturesAreKept) {
  const auto textured = [](double a) {
    Scene scene = room(a);
    ref::Texture noise{"noise", 16, 16, {}};
    for (unsigned n = 0, state = 7; n < 256; ++n, state = state * 1664525 + 1013904223)
      noise.texels.push_back({std::uint8_t(state >> 24), std::uint8_t(state >> 16), 128});
    scene.textures = {noise};
    scene.materials[0].texture = 0;
    for (ref::Mesh& mesh : scene.meshes) {
      for (const glm::dvec3& p : mesh.positions) mesh.texture_coordinates.emplace_back(p.x, p.y);
    }
    return scene;
  };
  const Configuration low = model::find_configuration("low");
  const Configuration colour = model::textured_configuration(low, TextureFilter::kBilinear);
  const Configuration motion =
      model::motion_configuration(colour, model::default_motion(colour.config()), kWidth, kHeight);
  model::KernelUpConversion mode{kWidth, kHeight, colour, motion};
  mode.static_buffer = true;
  KernelUpConverter with(mode);
  with.set_keys(textured(0), textured(1));
  const KernelFrameBetween made = with.at(textured(0.4), 0.4);
  EXPECT_EQ(made.static_instances, 3u);
  std::vector<bool> moves(made.rendered.size(), false);
  for (const model::RawMotion& word : with.input().motion) moves[std::size_t(word.y) * kWidth + word.x] = true;
  for (std::size_t n = 0; n < moves.size(); ++n) {
    if (!moves[n]) {
      EXPECT_EQ(made.colour[n], made.rendered[n]) << n;
    }
  }
}

TEST(StaticUpConversion, TheReferenceHasTheSamePixels) {
  const Configuration colour = model::find_configuration("middle");
  ref::UpConversion mode{kWidth, kHeight, model::raster_format(colour)};
  mode.mapping = ref::VectorMapping::kPerspective;
  mode.relight = true;
  ref::Interval ordinary(room(0), room(1), mode);
  mode.static_buffer = true;
  ref::Interval with(room(0), room(1), mode);
  KernelUpConverter kernels(mode_of("middle", true));
  kernels.set_keys(room(0), room(1));
  for (const double a : {0.2, 0.6}) {
    const ref::FrameBetween made = with.at(room(a), a), all = ordinary.at(room(a), a);
    const KernelFrameBetween by_kernels = kernels.at(room(a), a);
    EXPECT_EQ(made.shares.still, by_kernels.shares.still);
    EXPECT_EQ(made.shares.background, by_kernels.shares.background);
    EXPECT_EQ(made.shares.background, all.shares.background);
    std::vector<bool> moves(made.rendered.size(), false);
    for (const model::RawMotion& word : kernels.input().motion) moves[std::size_t(word.y) * kWidth + word.x] = true;
    for (std::size_t n = 0; n < moves.size(); ++n) {
      EXPECT_EQ(made.colour[n], moves[n] ? all.colour[n] : made.rendered[n]) << n;
    }
  }
}

TEST(StaticUpConversion, RefusesWhatHasNoDepthASample) {
  model::KernelUpConversion mode = mode_of("low", true);
  mode.half_field = true;
  EXPECT_THROW(KernelUpConverter{mode}, ref::Error);
  mode.half_field = false, mode.method = ref::MotionMethod::kStraight;
  EXPECT_THROW(KernelUpConverter{mode}, ref::Error);
  mode.static_buffer = false;
  EXPECT_NO_THROW(KernelUpConverter{mode});
  Config flat = model::find_configuration("low").config();
  flat.architecture = Architecture::kGamma;
  const Configuration gamma("gamma", flat);
  model::KernelUpConversion planes{kWidth, kHeight, gamma,
                                   model::motion_configuration(gamma, model::default_motion(flat), kWidth, kHeight)};
  planes.static_buffer = true;
  EXPECT_THROW(KernelUpConverter{planes}, ref::Error);
  ref::UpConversion reference{kWidth, kHeight, model::raster_format("low")};
  reference.static_buffer = true, reference.field = ref::FieldSize::kHalf;
  EXPECT_THROW(ref::Interval(room(0), room(1), reference), ref::Error);
  reference.field = ref::FieldSize::kSamples, reference.method = ref::MotionMethod::kStraight;
  EXPECT_THROW(ref::Interval(room(0), room(1), reference), ref::Error);
}

}  // namespace
}  // namespace halfspace
