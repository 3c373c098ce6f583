// SPDX-License-Identifier: Apache-2.0
// Gouraud or flat, with depth or without, with a Z-buffer or TdbV: the kernels against the reference, compiled against
// read at run time, and what is not there is in no word, no package and no file.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "model/package/package.hpp"
#include "model/pipeline/engine_impl.hpp"
#include "ref/error.hpp"
#include "study/trade/accuracy.hpp"
#include "tests/config_path.hpp"
#include "tests/formats/feature_configs.hpp"
#include "tests/formats/streams_of.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

using model::Configuration;

template <class C>
class Features : public testing::Test {
 protected:
  const Config config = C::config();
  const Configuration configuration{config.name, config};
  const ref::RasterFormat format = model::raster_format(configuration);

  std::vector<model::NamedFrame> frames(std::uint64_t seed) const {
    std::vector<model::NamedFrame> frames = model::corner_frames(format);
    for (auto& frame : model::random_frames(format, seed, 12, 80)) frames.push_back(std::move(frame));
    return frames;
  }
  // One triangle over the frame a rotation of the vertices, at the depths and in the colours given.
  ref::SnappedTriangle triangle(int rotation, std::uint32_t depth) const {
    const int one = 1 << format.subpixel_bits;
    const std::array<int, 3> x{0, 200 * one, 0}, y{0, 0, 200 * one};
    const std::array<std::array<std::uint8_t, 3>, 3> rgb{{{200, 10, 40}, {20, 180, 90}, {60, 30, 250}}};
    ref::SnappedTriangle t{};
    for (int v = 0; v < 3; ++v) {
      const int from = (v + rotation) % 3;
      t.x[v] = x[from], t.y[v] = y[from], t.rgb[v] = rgb[from];
      t.depth[v] = has_depth(config) ? depth : 0;
    }
    return t;
  }
};

using Combinations = testing::Types<GouraudDepth, GouraudOnly, FlatDepth, FlatOnly, Gamma>;
TYPED_TEST_SUITE(Features, Combinations);

TYPED_TEST(Features, CompiledAndAtRunTimeAreTheSameBits) {
  const auto frames = this->frames(5);
  const auto expect_same = [&](model::Engine& compiled, int lanes) {
    const std::string streams = streams_of(compiled, frames);
    EXPECT_GT(streams.size(), 100000u);
    EXPECT_TRUE(streams == streams_of(*model::make_engine(this->configuration, lanes), frames)) << lanes << " lanes";
  };
  model::KernelEngine<Formats<TypeParam, Stamp1>> one;
  expect_same(one, 1);
  model::KernelEngine<Formats<TypeParam, Stamp4>> four;
  expect_same(four, 4);
}

TYPED_TEST(Features, AgreesWithTheReference) {
  model::KernelEngine<Formats<TypeParam, Stamp4>> engine;
  std::uint64_t compared = 0, colour_differ = 0;
  for (const auto& frame : this->frames(9)) {
    SCOPED_TRACE(frame.note);
    const ref::Frame reference = ref::render(frame.scene), kernels = engine.render(frame.scene);
    const model::Accuracy a = model::accuracy(reference, kernels, this->config.depth_bits);
    EXPECT_EQ(a.covered_differ, 0u);
    EXPECT_LE(a.colour_largest, is_gouraud(this->config) ? 1 : 0);
    if (has_depth(this->config)) {
      EXPECT_LE(a.depth_largest, 1);
      EXPECT_LE(double(a.index_differ), 0.02 * double(a.pixels));
    } else {
      EXPECT_EQ(reference.index, kernels.index);
      EXPECT_EQ(reference.visible, kernels.visible);
      EXPECT_EQ(kernels.depth, std::vector<std::uint32_t>(kernels.index.size(), 0));
      EXPECT_EQ(reference.depth, kernels.depth);
    }
    compared += a.compared;
    colour_differ += a.colour_differ;
  }
  EXPECT_GT(compared, 10000u);
  std::printf("%-14s %llu pixels shown, colour differs in %llu channels\n", this->config.name,
              static_cast<unsigned long long>(compared), static_cast<unsigned long long>(colour_differ));
}

// The vertex that comes first gives a flat triangle its colour, in whatever place and winding the kernel puts it.
TYPED_TEST(Features, FirstVertexIsTheColourOfAFlatTriangle) {
  const auto engine = model::make_engine(this->configuration, 1);
  for (int rotation = 0; rotation < 3; ++rotation) {
    for (const bool mirrored : {false, true}) {
      ref::SnappedTriangle t = this->triangle(rotation, 1000);
      if (mirrored) std::swap(t.x[1], t.x[2]), std::swap(t.y[1], t.y[2]), std::swap(t.rgb[1], t.rgb[2]);
      const ref::SnappedList scene{this->format, 40, 30, {0, 0, 0}, {t}};
      for (const ref::Frame& frame : {engine->render(scene), ref::render(scene)}) {
        std::size_t of_first = 0;
        for (const auto& colour : frame.colour) {
          of_first += colour[0] == t.rgb[0][0] && colour[1] == t.rgb[0][1] && colour[2] == t.rgb[0][2];
        }
        if (is_gouraud(this->config)) EXPECT_LT(of_first, frame.colour.size() / 10);
        else EXPECT_EQ(of_first, frame.colour.size());
      }
    }
  }
}

// The nearer one is drawn second: it is seen with depth, and not without.
TYPED_TEST(Features, FirstDrawnWinsWithoutDepth) {
  const auto engine = model::make_engine(this->configuration, 4);
  const ref::SnappedList scene{this->format, 40, 30, {0, 0, 0}, {this->triangle(0, 2000), this->triangle(1, 1000)}};
  const std::uint32_t seen = has_depth(this->config) ? 2 : 1;
  for (const ref::Frame& frame : {engine->render(scene), ref::render(scene)}) {
    EXPECT_EQ(frame.index, std::vector<std::uint32_t>(40 * 30, seen));
    EXPECT_TRUE(frame.visible[0]);
    EXPECT_EQ(frame.visible[1], seen == 2);
  }
}

TYPED_TEST(Features, NoWordHasWhatIsNotThere) {
  std::string depths, colours, reciprocals;
  for (const model::Layout& layout : model::make_engine(this->configuration, 4)->layouts()) {
    for (const model::Field& field : layout.fields) {
      const std::string name = " " + layout.stream + "." + field.name;
      if (field.name.rfind("depth", 0) == 0) depths += name;
      if (field.name == "reciprocal" || field.name == "shift") reciprocals += name;
      if (field.name == "r" || field.name == "r0" || field.name == "r1" || field.name == "r_dx") {
        colours += name + ":" + std::to_string(field.width);
      }
    }
  }
  const char* const of_setup =
      " triangle.depth0 triangle.depth1 triangle.depth2 setup.depth setup.depth_dx setup.depth_dy";
  EXPECT_EQ(depths, stores_depth(this->config) ? of_setup + std::string(" stamp.depth update.depth")
                    : tests_planes(this->config)
                        ? of_setup + std::string(" triangle_depth.depth triangle_depth.depth_dx "
                                                 "triangle_depth.depth_dy stamp.depth")
                        : "");
  EXPECT_EQ(colours, is_gouraud(this->config)
                         ? " triangle.r0:8 triangle.r1:8 attributes.r0:8 attributes.r1:8 planes.r:22 "
                           "planes.r_dx:22 pixel.r:8"
                         : " triangle.r:8 attributes.r:8 planes.r:8 pixel.r:8");
  EXPECT_EQ(reciprocals, is_gouraud(this->config) ? " attributes.shift attributes.reciprocal" : "");
}

// Benches and synthesis take it from there.
TYPED_TEST(Features, PackageHasNoTypeOfWhatIsNotThere) {
  const std::string text = model::formats_package(this->configuration);
  const auto has = [&](const char* part) { return text.find(part) != std::string::npos; };
  EXPECT_EQ(has("HasDepth = 1;"), has_depth(this->config));
  EXPECT_EQ(has("StoresDepth = 1;"), stores_depth(this->config));
  EXPECT_EQ(has("triangle_depth_t;"), tests_planes(this->config));
  EXPECT_EQ(has("Gouraud = 1;"), is_gouraud(this->config));
  EXPECT_EQ(has("DepthBits = 18;"), has_depth(this->config));
  EXPECT_EQ(has("depth"), has_depth(this->config));
  EXPECT_EQ(has("colour_gradient_t"), is_gouraud(this->config));
  EXPECT_EQ(has("r_dx"), is_gouraud(this->config));
  EXPECT_EQ(has("reciprocal_t"), has_planes(this->config));
  EXPECT_EQ(has("ReciprocalBits = 0;"), !has_planes(this->config));
}

// feature_configs.hpp, for the compiler, and tests/configs/*.toml, for the benches, are the same.
TYPED_TEST(Features, FileIsTheHeader) {
  std::ifstream file(config_path(this->config.name));
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), model::configuration_toml(this->configuration));
}

TYPED_TEST(Features, FileReadsBack) {
  const std::string toml = model::configuration_toml(this->configuration);
  const Configuration again = model::parse_configuration(toml, "x.toml");
  EXPECT_EQ(model::configuration_toml(again), toml);
  EXPECT_EQ(model::configuration_header(again), model::configuration_header(this->configuration));
  EXPECT_EQ(again.config().shading, this->config.shading);
  EXPECT_EQ(again.config().architecture, this->config.architecture);
  const std::string middle = model::configuration_toml(model::find_configuration("middle"));
  EXPECT_TRUE(is_gouraud(model::parse_configuration(middle.substr(0, middle.find("shading")), "x.toml").config()));
}

// Nothing that means nothing is asked for, and nothing of it is taken.
TEST(FeatureRefusals, AreOfWhatIsThere) {
  const std::string idle = "numbers of what is not there are 0";
  Config c = FlatOnly::config();
  EXPECT_EQ(refusal_of(c), "accepted");
  for (int Config::*number : {&Config::reciprocal_bits, &Config::depth_fraction, &Config::colour_fraction}) {
    Config one = c;
    one.*number = 12;
    EXPECT_NE(refusal_of(one).find(idle), std::string::npos) << refusal_of(one);
  }
  c = GouraudOnly::config();
  c.depth_fraction = 12;
  EXPECT_NE(refusal_of(c).find(idle), std::string::npos) << refusal_of(c);
  c = FlatDepth::config();
  c.colour_fraction = 12;
  EXPECT_NE(refusal_of(c).find(idle), std::string::npos) << refusal_of(c);
  // What is there still has to be right.
  c = GouraudOnly::config();
  c.colour_fraction = 9;
  EXPECT_NE(refusal_of(c).find("colour planes"), std::string::npos) << refusal_of(c);
  c = GouraudOnly::config();
  c.reciprocal_bits = 0;
  EXPECT_NE(refusal_of(c).find("reciprocal_bits is 2 to 40"), std::string::npos) << refusal_of(c);
  c = FlatDepth::config();
  c.depth_fraction = 9;
  EXPECT_NE(refusal_of(c).find("depth planes"), std::string::npos) << refusal_of(c);
  const std::string toml = model::configuration_toml(Configuration("x", FlatDepth::config()));
  for (const char* line : {"shading = \"blinn\"", "shading = 1"}) {
    std::string text = toml;
    text.replace(text.find("shading = \"flat\""), 16, line);
    try {
      model::parse_configuration(text, "x.toml");
      ADD_FAILURE() << "accepted: " << line;
    } catch (const ref::Error& e) {
      EXPECT_NE(std::string(e.what()).find("x.toml:13: shading is \"gouraud\", \"flat\", \"phong\" or \"motion\""),
                std::string::npos)
          << e.what();
    }
  }
  c = FlatDepth::config();
  c.depth_bits = 1;
  EXPECT_NE(refusal_of(c).find("depth_bits is 2 to 32, or 0"), std::string::npos) << refusal_of(c);
}

}  // namespace
}  // namespace halfspace::tests
