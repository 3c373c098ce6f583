// SPDX-License-Identifier: Apache-2.0
// The top function of motion_compensate, fields as plain integers, gives the words of the kernel, the same at run time.
#include <gtest/gtest.h>

#include "hls/motion/motion_compensate.hpp"
#include "hls/top/fields.hpp"
#include "model/formats/field_value.hpp"
#include "vectors/frames/compensation_frames.hpp"

using TopKeyBlock = halfspace::KeyBlock<halfspace::TopFormats, halfspace::key_side(halfspace::TopFormats::kFilter)>;
extern "C" void motion_compensate_top(int, int, int, const std::int64_t*, const TopKeyBlock*, const TopKeyBlock*,
                                      std::int64_t*);

namespace halfspace::tests {
namespace {

using F = TopFormats;
constexpr int kSide = key_side(F::kFilter);

std::vector<TopKeyBlock> memory_of(const model::KeyFrame& key) {
  const int tiles_x = (key.width + 7) / 8, tiles_y = (key.height + 7) / 8;
  std::vector<TopKeyBlock> memory(std::size_t(tiles_x * tiles_y * blocks_a_tile(kSide)));
  for (int y = 0; y < key.height; ++y) {
    for (int x = 0; x < key.width; ++x) {
      const int block =
          (y / 8 * tiles_x + x / 8) * blocks_a_tile(kSide) + y % 8 / kSide * blocks_a_row(kSide) + x % 8 / kSide;
      TopKeyBlock& out = memory[std::size_t(block)];
      const int lane = y % kSide * kSide + x % kSide;
      const std::size_t at = std::size_t(y) * key.width + x;
      out.r[lane] = from_raw<F::Colour>(key.rgb[at][0]);
      out.g[lane] = from_raw<F::Colour>(key.rgb[at][1]);
      out.b[lane] = from_raw<F::Colour>(key.rgb[at][2]);
      out.face[lane] = from_raw<F::Face>(key.face[at]);
    }
  }
  return memory;
}

std::vector<std::int64_t> fields_of(const model::Layout& layout, const model::Word& word) {
  std::vector<std::int64_t> fields;
  for (const model::Field& field : layout.fields) fields.push_back(model::field_value(word, field));
  return fields;
}

TEST(CompensateTop, GivesTheWordsOfTheKernel) {
  const model::Compensator compensator(model::Configuration(F::config().name, F::config()));
  std::size_t compared = 0, shown = 0;
  for (const model::NamedCompensation& frame : model::compensation_frames(F::config(), 5)) {
    std::vector<model::StreamWords> streams;
    compensator.capture(frame.input(), streams);
    const model::StreamWords *motion = nullptr, *compensated = nullptr;
    for (const model::StreamWords& stream : streams) {
      if (stream.layout.stream == "motion") motion = &stream;
      if (stream.layout.stream == "compensated") compensated = &stream;
    }
    ASSERT_TRUE(motion && compensated);
    ASSERT_EQ(int(motion->layout.fields.size()), kMotionFields);
    ASSERT_EQ(int(compensated->layout.fields.size()), kCompensatedFields);
    const std::vector<TopKeyBlock> memory_0 = memory_of(frame.key[0]), memory_1 = memory_of(frame.key[1]);
    for (std::size_t n = 0; n < motion->words.size(); ++n) {
      std::vector<std::int64_t> got(std::size_t(kCompensatedFields) + 1, -1);
      motion_compensate_top(frame.width, frame.height, frame.weight, fields_of(motion->layout, motion->words[n]).data(),
                            memory_0.data(), memory_1.data(), got.data());
      ASSERT_EQ(got.back(), -1);
      got.pop_back();
      ASSERT_EQ(got, fields_of(compensated->layout, compensated->words[n])) << frame.note << ", word " << n;
      ++compared;
      shown += got.back() != 0;
    }
  }
  EXPECT_GT(compared, 1000u);
  EXPECT_GT(shown, 500u);
}

// A key frame's own table, as compiled.
TEST(CompensateTop, HasTheTablesOfItsConfiguration) {
  static constexpr KeyWeights<F> kWeights = key_weights<F>();
  for (int n = 0; n < 1 << KeyWeights<F>::kFraction; ++n) {
    const AxisWeights want = axis_weights(inner_filter(F::kFilter), n, KeyWeights<F>::kFraction, F::kWeightBits);
    for (int i = 0; i < kMostTaps; ++i) ASSERT_EQ(kWeights.inner[n].tap[i], want.tap[i]);
  }
}

}  // namespace
}  // namespace halfspace::tests
