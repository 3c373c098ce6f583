// SPDX-License-Identifier: Apache-2.0
// The pipeline as processes on streams as deep as those of the RTL: nothing hangs, and the words are those of the
// engine that calls one unit after the other. A stream that is too short hangs, and is named. The depths are those of
// the RTL.
#include "tests/pipeline/bounded_engine.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <sstream>

#include "hls/formats/configs/low.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/scene/scene.hpp"
#include "tests/formats/feature_configs.hpp"
#include "tests/formats/streams_of.hpp"
#include "tests/motion/motion_configs.hpp"
#include "tests/objects/object_configs.hpp"
#include "tests/shade/lit_configs.hpp"
#include "tests/texture/textured_configs.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

// Names of this file alone: no kernel on other streams is taken for one of these.
struct OwnLow : Low {};
struct OwnGamma : Gamma {};
struct OwnLit : LitLow {};
struct OwnPhong : PhongLow {};
struct OwnTextured : TexturedLow {};
struct OwnTexturedPhong : TexturedPhong {};
struct OwnMotion : MotionLow {};
struct OwnObjects : ObjectsLow {};

using model::Configuration;
using model::NamedFrame;

template <class C>
NamedFrame with_answers(NamedFrame frame) {
  const std::size_t count = frame.scene.triangles.size();
  if (has_lighting(C::config())) frame.lighting = model::awkward_normals(count, C::config(), 5);
  if (has_texture(C::config())) frame.texture = model::awkward_coordinates(count, C::config(), 5);
  if (has_motion(C::config())) frame.motion = model::awkward_motion(frame.scene, C::config(), 9);
  return frame;
}

template <class C>
class Bounded : public testing::Test {
 protected:
  const Configuration configuration{C::config().name, C::config()};
  const ref::RasterFormat format = model::raster_format(configuration);

  NamedFrame random_frame(int triangles) const {
    return with_answers<C>(model::random_frames(format, 5, 1, triangles).front());
  }
  NamedFrame scene(const char* name) const {
    return with_answers<C>(
        {name,
         ref::snap(ref::project(ref::load_scene(name), {96, 72, format.range_bits, format.subpixel_bits}), format)});
  }

  template <class Stamp>
  void expect_words(const NamedFrame& frame) {
    SCOPED_TRACE(frame.note);
    const auto unbounded = model::make_engine(configuration, Stamp::kX * Stamp::kY);
    BoundedEngine<Formats<C, Stamp>> engine;
    for (model::Engine* each : {unbounded.get(), static_cast<model::Engine*>(&engine)})
      model::load_frame(*each, configuration.config(), frame);
    const std::string words = streams_of(engine, {frame});
    ASSERT_EQ(engine.report, "");
    EXPECT_GT(words.size(), 10000u);
    EXPECT_TRUE(words == streams_of(*unbounded, {frame}));
    const ref::Frame got = engine.render(frame.scene), want = unbounded->render(frame.scene);
    EXPECT_EQ(engine.report, "");
    EXPECT_TRUE(got.index == want.index && got.depth == want.depth && got.colour == want.colour);
    EXPECT_EQ(got.visible, want.visible);
  }
};

using Configs =
    testing::Types<OwnLow, OwnGamma, OwnLit, OwnPhong, OwnTextured, OwnTexturedPhong, OwnMotion, OwnObjects>;
TYPED_TEST_SUITE(Bounded, Configs);

TYPED_TEST(Bounded, GivesTheWordsOfTheUnboundedEngine) {
  this->template expect_words<Stamp1>(this->random_frame(60));
  this->template expect_words<Stamp4>(this->random_frame(60));
  this->template expect_words<Stamp4>(this->random_frame(700));  // more than may be ahead
  this->template expect_words<Stamp4>(this->scene("castle"));
}

template <class C>
std::string report_of(const NamedFrame& frame, const std::string& stream, int depth) {
  BoundedEngine<Formats<C, Stamp4>> engine;
  model::load_frame(engine, C::config(), frame);
  engine.depths[stream] = depth;
  engine.render(frame.scene);
  return engine.report;
}

// Geometry has 60 triangles to send before it takes a word.
TYPED_TEST(Bounded, HangsWithAShortQueueOfSetupsAndNamesIt) {
  const std::string report = report_of<TypeParam>(this->random_frame(60), "setup", 2);
  EXPECT_NE(report.find("triangle_setup waits: setup is full, depth 2\n"), std::string::npos) << report;
  EXPECT_NE(report.find("geometry waits: triangle is full, depth 1\n"), std::string::npos) << report;
}
TYPED_TEST(Bounded, HangsWithAShortQueueOfDeferredAttributesAndNamesIt) {
  const std::string report = report_of<TypeParam>(this->random_frame(60), "attributes", 2);
  if (Formats<TypeParam, Stamp4>::kDeferred) {
    EXPECT_NE(report.find("triangle_setup waits: attributes is full, depth 2\n"), std::string::npos) << report;
    EXPECT_NE(report.find("geometry waits: triangle is full, depth 1\n"), std::string::npos) << report;
  } else {
    EXPECT_EQ(report, "");  // their planes are made and stored whatever becomes of the triangle
  }
}

// What is short, and hangs not: the others are there for the rate.
TYPED_TEST(Bounded, OneWordInEveryOtherStreamIsEnough) {
  BoundedEngine<Formats<TypeParam, Stamp4>> engine;
  const NamedFrame frame = this->random_frame(60);
  model::load_frame(engine, TypeParam::config(), frame);
  for (const char* stream : {"triangle_depth", "stamp", "visible_attributes", "colours", "scan", "pixel_scan",
                             "object_scan", "coloured_scan", "texed_scan"}) {
    engine.depths[stream] = 1;
  }
  engine.render(frame.scene);
  EXPECT_EQ(engine.report, "");
}

// The value of a parameter of a module of the RTL: a number, or one of two by what a configuration has.
template <class F>
int parameter_of(const std::string& module, const std::string& parameter) {
  std::ifstream file(HALFSPACE_SOURCE "/rtl/pipeline/" + module + ".sv");
  std::stringstream text;
  text << file.rdbuf();
  const std::string source = text.str();
  std::smatch found;
  if (!std::regex_search(source, found, std::regex("unsigned " + parameter + "\\s*=\\s*([^,]+),"))) return -1;
  const std::string value = found[1];
  if (value.find('?') == std::string::npos) return std::stoi(value);
  const std::string condition = value.substr(0, value.find('?'));
  const bool is_there = (condition.find("::Phong ") != std::string::npos && F::kPhong) ||
                        (condition.find("::HasTexture ") != std::string::npos && F::kHasTexture);
  return std::stoi(value.substr(value.find(is_there ? '?' : ':', value.find('?')) + 1));
}

TYPED_TEST(Bounded, DepthsAreThoseOfTheRtl) {
  using F = Formats<TypeParam, Stamp4>;
  int queues = 0;
  const auto expect_depth = [&](const char* stream, int depth, const std::string& fifo) {
    if (fifo.empty()) {
      EXPECT_EQ(depth, 1) << stream;
      return;
    }
    const std::size_t space = fifo.find(' ');
    EXPECT_EQ(depth, parameter_of<F>(fifo.substr(0, space), fifo.substr(space + 1))) << stream << ": " << fifo;
    ++queues;
  };
#define HS_EXPECT(member, depth, fifo) expect_depth(#member, depth, fifo);
  HS_STREAM_DEPTHS(HS_EXPECT)
#undef HS_EXPECT
  EXPECT_GE(queues, 8);
}

}  // namespace
}  // namespace halfspace::tests
