// SPDX-License-Identifier: Apache-2.0
// Shaders that take a frame at once give what they give by stamps.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "hls/shade/shade_gouraud.hpp"
#include "hls/shade/shade_phong.hpp"
#include "tests/formats/record_fields.hpp"

namespace halfspace::tests {
namespace {

struct PhongThree {
  static constexpr Config config() {
    Config config = Low::config();
    config.shading = Shading::kPhong;
    config.colour_fraction = 0;
    config.normal_bits = 9, config.lights = 3, config.gloss = 16, config.materials = 4, config.normal_fraction = 13;
    return config;
  }
};

std::mt19937_64 random_bits(7);

template <class T>
void randomize(T& record) {
  record.visit(Randomize{random_bits});
}

constexpr int kStamps = 500, kNames = 6;

// Stamps of few triangles each, and background.
template <class F>
std::vector<Scan<F>> stamps() {
  std::vector<Scan<F>> result(kStamps);
  for (Scan<F>& stamp : result) {
    randomize(stamp);
    for (auto& index : stamp.index) index = from_raw<typename F::Index>(random_bits() % kNames);
    stamp.last = from_raw<Bit>(&stamp == &result.back());
  }
  return result;
}

// shade: one call; shade_frame: one call for all.
template <class F, class Shade, class ShadeFrame>
void expect_equal(Shade shade, ShadeFrame shade_frame) {
  Frame<F> frame{};
  frame.r = from_raw<typename F::Colour>(17);
  frame.g = from_raw<typename F::Colour>(99);
  frame.b = from_raw<typename F::Colour>(201);
  Stream<Scan<F>> one, whole;
  Stream<Pixel<F>> of_one, of_whole;
  for (const Scan<F>& stamp : stamps<F>()) one.write(stamp), whole.write(stamp);
  for (int n = 0; n < kStamps; ++n) EXPECT_EQ(shade(frame, one, of_one), n == kStamps - 1);
  shade_frame(frame, whole, of_whole);
  EXPECT_TRUE(whole.empty());
  const std::vector<std::int64_t> pixels = drain(of_one);
  EXPECT_EQ(pixels.size(), std::size_t(kStamps * (3 + 3 * F::kLanes)));
  EXPECT_EQ(drain(of_whole), pixels);
}

template <class F>
void expect_gouraud() {
  const auto database = std::make_unique<ShadingDatabase<F>>();
  for (int n = 0; n < kNames; ++n) randomize(database->planes[n]);
  expect_equal<F>([&](auto& frame, auto& in, auto& out) { return shade_gouraud(frame, in, *database, out); },
                  [&](auto& frame, auto& in, auto& out) { shade_gouraud_frame(frame, in, *database, out); });
}
TEST(ShadedFrame, IsItsStamps) {
  expect_gouraud<Formats<Low, Stamp1>>();
  expect_gouraud<Formats<Middle, Stamp16>>();
}

template <class F>
void expect_phong() {
  const auto database = std::make_unique<NormalDatabase<F>>();
  LightTable<F> lights{};
  MaterialTable<F> materials{};
  for (int n = 0; n < kNames; ++n) randomize(database->planes[n]);
  for (auto& light : lights.light) randomize(light);
  for (auto& material : materials.entry) {
    for (auto& entry : material) randomize(entry);
  }
  expect_equal<F>(
      [&](auto& frame, auto& in, auto& out) { return shade_phong(frame, in, *database, lights, materials, out); },
      [&](auto& frame, auto& in, auto& out) { shade_phong_frame(frame, in, *database, lights, materials, out); });
}
TEST(ShadedFrame, IsItsStampsWithLights) {
  expect_phong<Formats<PhongThree, Stamp1>>();
  expect_phong<Formats<PhongThree, Stamp4>>();
}

}  // namespace
}  // namespace halfspace::tests
