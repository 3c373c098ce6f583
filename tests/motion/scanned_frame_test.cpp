// SPDX-License-Identifier: Apache-2.0
// Units that take the pixels of a whole frame give what they give by stamps: texture and the motion field.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "hls/motion/motion_field.hpp"
#include "hls/texture/shade_texture.hpp"
#include "tests/formats/record_fields.hpp"
#include "tests/motion/motion_configs.hpp"
#include "tests/texture/textured_configs.hpp"

namespace halfspace::tests {
namespace {

std::mt19937_64 random_bits(11);

constexpr int kStamps = 400, kNames = 5;

// Stamps of few triangles; of every third one at most a lane is covered, as the last one is not at all if `ends_empty`.
template <class F>
std::vector<Scan<F>> stamps(bool ends_empty) {
  std::vector<Scan<F>> result(kStamps);
  for (Scan<F>& stamp : result) {
    stamp.visit(Randomize{random_bits});
    for (auto& index : stamp.index) index = from_raw<typename F::Index>(random_bits() % kNames);
    const bool is_last = &stamp == &result.back();
    stamp.last = from_raw<Bit>(is_last);
    if (is_last ? ends_empty : random_bits() % 3 == 0) {
      const auto kept = stamp.index[0];
      for (auto& index : stamp.index) index = from_raw<typename F::Index>(0);
      if (!is_last) stamp.index[random_bits() % F::kLanes] = kept;
    }
  }
  return result;
}

template <class F>
void expect_texture(bool ends_empty) {
  const auto database = std::make_unique<TextureDatabase<F>>();
  const auto table = std::make_unique<TextureTable<F>>();
  const auto memory = std::make_unique<TextureMemory<F>>();
  for (int n = 0; n < kNames; ++n) {
    database->planes[n].visit(Randomize{random_bits});
    database->planes[n].texture = from_raw<typename F::TextureNumber>(n);
    table->entry[n].log2_width = table->entry[n].log2_height = from_raw<typename F::Side>(3);
    table->entry[n].base = from_raw<typename F::TexelAddress>(64 * n);
  }
  for (auto& bank : memory->bank) {
    for (auto& texel : bank) texel.r = texel.g = texel.b = from_raw<typename F::Colour>(random_bits());
  }
  Stream<Scan<F>> one, whole;
  Stream<Pixel<F>> lit_one, lit_whole, of_one, of_whole;
  for (const Scan<F>& stamp : stamps<F>(ends_empty)) {
    Pixel<F> lit;
    lit.visit(Randomize{random_bits});
    one.write(stamp), whole.write(stamp);
    lit_one.write(lit), lit_whole.write(lit);
  }
  for (int n = 0; n < kStamps; ++n) {
    EXPECT_EQ(shade_texture(one, lit_one, *database, *table, *memory, of_one), n == kStamps - 1);
  }
  shade_texture_frame(whole, lit_whole, *database, *table, *memory, of_whole);
  EXPECT_TRUE(whole.empty() && lit_whole.empty());
  const std::vector<std::int64_t> pixels = drain(of_one);
  EXPECT_EQ(pixels.size(), std::size_t(kStamps * (3 + 3 * F::kLanes)));
  EXPECT_EQ(drain(of_whole), pixels);
}
TEST(ScannedFrame, OfTextureIsItsStamps) {
  expect_texture<Formats<TexturedLow, Stamp1>>(false);
  expect_texture<Formats<TexturedMiddle, Stamp4>>(false);
  expect_texture<Formats<TexturedMiddle, Stamp16>>(true);
}

template <class F>
void expect_motion(bool ends_empty) {
  const auto database = std::make_unique<MotionDatabase<F>>();
  for (int n = 0; n < kNames; ++n) {
    database->planes[n].visit(Randomize{random_bits});
    for (auto& key : database->planes[n].key) key.extent = from_raw<typename F::Extent>(random_bits() % 8);
  }
  Stream<Scan<F>> one, whole;
  Stream<Motion<F>> of_one, of_whole;
  std::size_t words = ends_empty, covered_in_last = 0;
  for (const Scan<F>& stamp : stamps<F>(ends_empty)) {
    one.write(stamp), whole.write(stamp);
    for (const auto& index : stamp.index)
      words += is_set(index), covered_in_last += is_set(index) && is_set(stamp.last);
  }
  if (!ends_empty && covered_in_last == 0) ++words;
  for (int n = 0; n < kStamps; ++n) EXPECT_EQ(motion_field(one, *database, of_one), n == kStamps - 1);
  motion_field_frame(whole, *database, of_whole);
  EXPECT_TRUE(whole.empty());
  Fields of_a_word;
  Motion<F>{}.visit(of_a_word);
  const std::vector<std::int64_t> motion = drain(of_one);
  EXPECT_EQ(motion.size(), words * of_a_word.values.size());
  EXPECT_EQ(drain(of_whole), motion);
}
TEST(ScannedFrame, OfMotionIsItsStamps) {
  expect_motion<Formats<MotionLow, Stamp1>>(false);
  expect_motion<Formats<MotionLow, Stamp1>>(true);
  expect_motion<Formats<MotionMiddle, Stamp4>>(true);
  expect_motion<Formats<MotionHigh, Stamp16>>(false);
}

}  // namespace
}  // namespace halfspace::tests
