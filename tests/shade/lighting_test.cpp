// SPDX-License-Identifier: Apache-2.0
// The lighting kernels against the exact formula on the same integers, within the bound of docs/numerics.md, and
// against the reference on the built-in scenes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "model/shade/lighting_engine.hpp"
#include "ref/error.hpp"
#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/viewpoint.hpp"
#include "ref/scene/scene.hpp"
#include "study/bounds/bounds_exact.hpp"
#include "study/bounds/lighting_measure.hpp"
#include "study/proofs/lighting_bounds.hpp"
#include "tests/config_path.hpp"
#include "tests/shade/lit_configs.hpp"

namespace halfspace::tests {
namespace {

using model::LightingFrame;
using model::Wide;

template <class C>
using LitFormats = Formats<C, Stamp1>;

// |y·√m − 1| < 2^−17, in integers: y = Y·2^−18 and m = q'·2^(2−T).
template <class F>
void expect_root(std::uint64_t q) {
  const int bits = F::SquaredLength::width();
  const auto got = reciprocal_sqrt<F>(from_raw<typename F::SquaredLength>(q));
  const std::uint64_t normalized = q << 2 * int(raw(got.shift));
  ASSERT_EQ(normalized >> bits, 0u) << q;
  ASSERT_NE(normalized >> (bits - 2), 0u) << q;
  const Wide y = raw(got.root), square = y * y * Wide(normalized) << 2;  // (y·√m)² in units of 2^−(T+36)
  const Wide one = Wide(1) << (bits + 2);                                // units of 2^−34
  const Wide below = (Wide(1) << 17) - 1, above = (Wide(1) << 17) + 1;
  ASSERT_GT(square, below * below * one) << q;
  ASSERT_LT(square, above * above * one) << q;
}

// Every field that the table sees, with nothing and with everything in the bits that are cut.
template <class F>
void expect_roots() {
  const int bits = F::SquaredLength::width(), field = kRootIndexBits + kRootOffsetBits;
  for (int octave = 0; octave < 2; ++octave) {
    const int cut = bits - 2 + octave - field;
    const std::uint64_t lead = std::uint64_t(1) << (bits - 2 + octave);
    for (std::uint64_t n = 0; n < std::uint64_t(1) << field; ++n) {
      // The shorter octave of the narrowest numbers has fewer places than the field.
      const std::uint64_t low = lead | (cut >= 0 ? n << cut : n >> -cut);
      expect_root<F>(low);
      if (cut > 0) expect_root<F>(low | ((std::uint64_t(1) << cut) - 1));
      if (testing::Test::HasFatalFailure()) return;
    }
  }
  std::mt19937_64 random(3);
  for (int n = 0; n < 100000; ++n) expect_root<F>(1 + random() % ((std::uint64_t(1) << (1 + n % bits)) - 1));
}
TEST(ReciprocalSqrt, IsWithinItsBoundEverywhere) {
  expect_roots<LitFormats<LitLow>>();
  expect_roots<LitFormats<LitMiddle>>();
  expect_roots<LitFormats<LitHigh>>();
}

struct Worst {
  std::uint64_t compared = 0;
  double error = 0, share = 0;
};

// Sums of all normals of a frame against the exact ones.
void compare(model::LightingEngine& engine, const LightingFrame& frame, const Config& config, Worst& worst) {
  const auto sums = engine.sums(frame);
  const NumberFormat format = format_table(config).light_sum;
  for (std::size_t t = 0; t < sums.size(); ++t) {
    for (int v = 0; v < (is_gouraud(config) ? 3 : 1); ++v) {
      const auto& normal = frame.triangles[t].normals[v];
      for (int c = 0; c < 3; ++c) {
        const model::RealNormal real = {(long double)normal[0], (long double)normal[1], (long double)normal[2]};
        const model::ExactLight exact = model::exact_light(frame, frame.triangles[t].material, real, c, config);
        const long double got = std::ldexp((long double)sums[t][v][c], format.integer - format.width);
        const double error = double(std::abs(got - exact.value));
        // 2^−40: what long double leaves of a power.
        ASSERT_LE(error, double(exact.bound) + std::ldexp(1.0, -40))
            << config.name << ", " << frame.note << ", triangle " << t << ", vertex " << v << ", channel " << c;
        ++worst.compared;
        worst.error = std::max(worst.error, error);
        if (exact.bound > 0) worst.share = std::max(worst.share, error / double(exact.bound));
      }
    }
  }
}

class Lighting : public testing::TestWithParam<Config> {};

TEST_P(Lighting, IsWithinTheBoundOfTheExactFormula) {
  const Config config = GetParam();
  const auto engine = model::make_lighting_engine(config);
  Worst frames;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    for (const LightingFrame& frame : model::lighting_frames(config, seed)) compare(*engine, frame, config, frames);
  }
  EXPECT_GT(frames.compared, 10000u);
  std::printf("%-10s %llu channels, at most %.4f of their bound\n", config.name,
              static_cast<unsigned long long>(frames.compared), frames.share);
  model::BoundsReport report = model::proved_bounds(config);
  model::measure_lighting(config, 11, 120, report);
  for (const auto quantity : {model::kLightCosine, model::kLightPower, model::kLightSum}) {
    const model::BoundRow& row = report.rows[quantity];
    if (!row.present()) continue;
    std::printf("%-10s %s: proved %.4f %s, seen %.4f of %llu\n", config.name, row.quantity.c_str(), row.proved,
                row.unit.c_str(), row.seen, static_cast<unsigned long long>(row.compared));
    EXPECT_EQ(row.exceeded, 0u) << row.quantity;
    EXPECT_GT(row.seen, row.proved / 2) << row.quantity << ": the search is blind, or the bound is loose";
  }
}

TEST_P(Lighting, ColoursAreRoundedSums) {
  const Config config = GetParam();
  const auto engine = model::make_lighting_engine(config);
  const NumberFormat format = format_table(config).light_sum;
  const int fraction = format.width - format.integer, full = (1 << config.colour_bits) - 1;
  int clamped = 0, compared = 0;
  for (const LightingFrame& frame : model::lighting_frames(config, 1)) {
    const auto sums = engine->sums(frame);
    const auto colours = engine->colours(frame);
    for (std::size_t t = 0; t < sums.size(); ++t) {
      for (int v = 0; v < (is_gouraud(config) ? 3 : 1); ++v) {
        for (int c = 0; c < 3; ++c, ++compared) {
          const double value = std::floor(std::ldexp(double(sums[t][v][c]), -fraction) + 0.5);
          ASSERT_EQ(colours[t][v][c], int(std::min(value, double(full))));
          clamped += value > full;
        }
      }
    }
  }
  EXPECT_GT(clamped, 100);
  EXPECT_GT(compared, 5 * clamped / 4);
}

// Formats read at run time, which everything else here uses, give the bits of compiled ones.
template <class C>
void expect_compiled_equal() {
  model::LightingKernels<LitFormats<C>> compiled;
  const auto runtime = model::make_lighting_engine(C::config());
  for (const LightingFrame& frame : model::lighting_frames(C::config(), 2)) {
    ASSERT_EQ(compiled.sums(frame), runtime->sums(frame)) << frame.note;
    ASSERT_EQ(compiled.colours(frame), runtime->colours(frame)) << frame.note;
  }
}
TEST(LightingFormats, CompiledAndReadAtRunTimeAreEqual) {
  expect_compiled_equal<LitLow>();
  expect_compiled_equal<LitMiddle>();
  expect_compiled_equal<LitHigh>();
  expect_compiled_equal<LitMatte>();
}

// The toml files that the RTL is built from say the same.
TEST(LightingFormats, FilesAndHeadersAgree) {
  for (const Config& config : {LitLow::config(), LitMiddle::config(), LitHigh::config(), LitMatte::config()}) {
    const model::Configuration file = model::find_configuration(config_path(config.name));
    EXPECT_EQ(model::configuration_toml(file), model::configuration_toml(model::Configuration(config.name, config)));
    EXPECT_EQ(model::configuration_toml(file),
              model::configuration_toml(model::parse_configuration(model::configuration_toml(file), "x.toml")));
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Lighting,
                         testing::Values(LitLow::config(), LitMiddle::config(), LitHigh::config(), LitMatte::config()),
                         [](const auto& info) { return std::string(info.param.name); });

// Vertex colours of every built-in scene, as it is and polished, under its light and under four, against the reference
// in doubles: 1 LSB of 8 at most.
void expect_scenes(bool polished) {
  const Config config = LitHigh::config();
  const auto engine = model::make_lighting_engine(config);
  for (const std::string& name : ref::builtin_scene_names()) {
    ref::Scene scene = ref::load_scene(name);
    if (polished) {
      for (ref::Material& material : scene.materials) material.specular = {0.9, 0.7, 1}, material.shininess = 14;
      for (const glm::dvec3& way : {glm::dvec3(-1, -1, -1), {1, -2, 0}, {0.3, 0.2, -1}, {-1, 0, 0.5}}) {
        scene.lights.push_back({});
        scene.lights.back().direction = glm::normalize(way);
        scene.lights.back().colour = {0.15, 0.2, 0.17};
      }
    }
    const ref::DistantScene distant =
        ref::distant_scene(scene, ref::viewpoint(scene, 16.0 / 9), model::most_squarings(config));
    const auto colours = engine->colours(model::quantized_lighting(distant, config));
    ASSERT_EQ(colours.size(), distant.triangles.size());
    double worst = 0;
    std::uint64_t channels = 0;
    for (std::size_t t = 0; t < colours.size(); ++t) {
      const ref::DistantTriangle& triangle = distant.triangles[t];
      for (int v = 0; v < 3; ++v) {
        const glm::dvec3 exact =
            ref::distant_colour(distant.materials[triangle.material], distant.lights, triangle.normals[v]);
        for (int c = 0; c < 3; ++c, ++channels) worst = std::max(worst, std::abs(colours[t][v][c] - exact[c]));
      }
    }
    std::printf("%-10s %zu lights, %zu materials, %llu channels: largest difference %.3f LSB\n", name.c_str(),
                distant.lights.size(), distant.materials.size(), static_cast<unsigned long long>(channels), worst);
    EXPECT_LE(worst, 1.0) << name;
    EXPECT_GT(channels, 0u);
  }
}
TEST(LightingScenes, VertexColoursAreThoseOfTheReference) { expect_scenes(false); }
TEST(LightingScenes, AndPolishedUnderFourLights) { expect_scenes(true); }

TEST(DistantLighting, RoundsTheExponentInItsLogarithm) {
  EXPECT_EQ(ref::squarings(0, 4), -1);
  EXPECT_EQ(ref::squarings(5, -1), -1);
  EXPECT_EQ(ref::squarings(0.3, 4), 0);
  EXPECT_EQ(ref::squarings(5, 4), 2);
  EXPECT_EQ(ref::squarings(6, 4), 3);
  EXPECT_EQ(ref::squarings(1000, 4), 4);
  EXPECT_EQ(ref::squarings(1000, 2), 2);
}

TEST(DistantLighting, IsTheFormula) {
  const ref::DistantMaterial material{{10, 20, 30}, 3, {{{100, 50, 0}, {0, 80, 160}}}};
  const std::vector<ref::DistantLight> lights = {{{0, 0, 1}, glm::normalize(glm::dvec3(1, 0, 1)), glm::dvec3(1)}};
  const glm::dvec3 n(0.3, 0.2, 0.9);
  const double length = std::sqrt(0.94), along = 0.9 / length, half = 1.2 / std::sqrt(2.0) / length;
  const glm::dvec3 got = ref::distant_colour(material, lights, n);
  EXPECT_NEAR(got.r, 10 + 100 * along, 1e-12);
  EXPECT_NEAR(got.g, 20 + 50 * along + 80 * std::pow(half, 8), 1e-12);
  EXPECT_NEAR(got.b, 30 + 160 * std::pow(half, 8), 1e-12);
  EXPECT_EQ(ref::distant_colour(material, lights, {1, 0, -1e-9}), material.base) << "a highlight behind the surface";
  EXPECT_EQ(ref::distant_colour(material, lights, {0, 0, 0}), material.base);
}

TEST(LightingRefusals, NameWhatIsWrong) {
  const auto refusal_of = [](auto change) { return halfspace::refusal_of(LitMiddle::config(), change); };
  EXPECT_EQ(refusal_of([](Config&) {}), "accepted");
  EXPECT_NE(refusal_of([](Config& c) { c.normal_bits = 8; }).find("normal_bits is 9 to 16"), std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.lights = 5; }).find("lights is 1 to 4"), std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.gloss = 12; }).find("gloss is 1, 2, 4, 8 or 16"), std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.materials = 0; }).find("materials is 1 to 4096"), std::string::npos);
  EXPECT_NE(refusal_of([](Config& c) { c.lights = 0; }).find("are 0 where lights is 0"), std::string::npos);
  ref::DistantScene scene;
  scene.lights.resize(3);
  EXPECT_THROW(model::quantized_lighting(scene, LitMiddle::config()), ref::Error);
}

}  // namespace
}  // namespace halfspace::tests
