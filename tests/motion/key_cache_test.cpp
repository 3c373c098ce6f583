// SPDX-License-Identifier: Apache-2.0
// The cache of a key frame: what it asks for, what it then holds, and that nothing is left of the frame before.
#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "hls/motion/key_cache.hpp"
#include "hls/motion/motion_compensate.hpp"
#include "tests/motion/motion_configs.hpp"

namespace halfspace::tests {
namespace {

using F = Formats<MotionLow, Stamp4>;
constexpr int kSide = key_side(F::kFilter);
static_assert(kSide == 2, "the filter of the configuration");

// A key frame whose pixels know where they are, and whose tiles are told.
struct Memory {
  std::vector<std::pair<int, int>> asked;
  int tile = 0, block = 0;

  static int colour(int tile, int block, int bank) { return (tile * 37 + block * 5 + bank) & 0xff; }
  void request(const KeyRequest<F>& at) {
    asked.emplace_back(int(raw(at.tile_x)), int(raw(at.tile_y)));
    tile = asked.back().first + 8 * asked.back().second, block = 0;
  }
  KeyBlock<F, kSide> read() {
    KeyBlock<F, kSide> out;
    for (int bank = 0; bank < kSide * kSide; ++bank) {
      out.r[bank] = from_raw<F::Colour>(colour(tile, block, bank));
      out.g[bank] = from_raw<F::Colour>(colour(tile, block, bank) + 1);
      out.b[bank] = from_raw<F::Colour>(colour(tile, block, bank) + 2);
      out.face[bank] = from_raw<F::Face>(tile + 1);
    }
    ++block;
    return out;
  }
};

template <class Tile>
KeyAxis<Tile, kSide> axis(int first, int last) {
  KeyAxis<Tile, kSide> out{};
  out.first_tile = from_raw<Tile>(first), out.last_tile = from_raw<Tile>(last);
  return out;
}

using Tiles = std::vector<std::pair<int, int>>;

class KeyCacheTest : public testing::Test {
 protected:
  KeyCacheTest() { empty_cache(*cache_); }
  // What is asked for of the tiles x0 … x1, y0 … y1.
  Tiles fill(int x0, int x1, int y0, int y1) {
    memory_.asked.clear();
    fill_cache(*cache_, axis<F::TileX>(x0, x1), axis<F::TileY>(y0, y1), memory_);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) expect_tile(x, y);
    }
    return memory_.asked;
  }
  void expect_tile(int x, int y) {
    for (int n = 0; n < blocks_a_tile(kSide); ++n) {
      for (int bank = 0; bank < kSide * kSide; ++bank) {
        const KeyPixel<F>& pixel = cache_->bank[bank][(y % 2 * 2 + x % 2) * blocks_a_tile(kSide) + n];
        const int want = Memory::colour(x + 8 * y, n, bank);
        ASSERT_EQ(int(raw(pixel.r)), want & 0xff);
        ASSERT_EQ(int(raw(pixel.g)), (want + 1) & 0xff);
        ASSERT_EQ(int(raw(pixel.b)), (want + 2) & 0xff);
        ASSERT_EQ(int(raw(pixel.face)), x + 8 * y + 1);
      }
    }
  }

  std::unique_ptr<KeyCache<F, kSide>> cache_ = std::make_unique<KeyCache<F, kSide>>();
  Memory memory_;
};

TEST_F(KeyCacheTest, AsksForWhatItLacks) {
  EXPECT_EQ(fill(2, 2, 3, 3), (Tiles{{2, 3}}));
  EXPECT_EQ(fill(2, 2, 3, 3), Tiles());
  EXPECT_EQ(fill(2, 3, 3, 3), (Tiles{{3, 3}}));
  EXPECT_EQ(fill(2, 3, 3, 4), (Tiles{{2, 4}, {3, 4}}));
  EXPECT_EQ(fill(2, 3, 3, 4), Tiles());
  // In the place of others.
  EXPECT_EQ(fill(3, 4, 4, 5), (Tiles{{4, 4}, {4, 5}, {3, 5}}));
  EXPECT_EQ(fill(5, 5, 4, 4), (Tiles{{5, 4}}));
  EXPECT_EQ(fill(3, 3, 4, 4), (Tiles{{3, 4}}));
  EXPECT_EQ(fill(3, 3, 2, 2), (Tiles{{3, 2}}));
}

TEST_F(KeyCacheTest, HoldsNothingOfTheFrameBefore) {
  fill(2, 3, 3, 4);
  EXPECT_EQ(fill(2, 3, 3, 4), Tiles());
  empty_cache(*cache_);
  EXPECT_EQ(fill(2, 3, 3, 4).size(), 4u);
}

// None has the first tile of all, either.
TEST_F(KeyCacheTest, HoldsNothingAtFirst) { EXPECT_EQ(fill(0, 1, 0, 1).size(), 4u); }

// The caches of both keys, while a frame lasts.
TEST(Compensation, LeavesEmptyCachesBehindAFrame) {
  static constexpr KeyWeights<F> kWeights = key_weights<F>();
  CompensationFrame<F> frame{};
  frame.width = from_raw<F::X>(40), frame.height = from_raw<F::Y>(40);
  KeyCache<F, kSide> cache[2];
  Memory memory[2];
  Stream<Motion<F>> motion;
  Stream<Compensated<F>> compensated;
  for (auto& one : cache) empty_cache(one);
  const auto held = [&](int key) {
    int number = 0;
    for (const bool valid : cache[key].valid) number += valid;
    return number;
  };
  for (const bool last : {false, true}) {
    Motion<F> word{};
    word.x = from_raw<F::X>(20), word.y = from_raw<F::Y>(20);
    word.face = from_raw<F::Face>(1);
    word.last = from_raw<Bit>(last);
    for (auto& key : word.key) key.there = from_raw<Bit>(1);
    motion.write(word);
    EXPECT_EQ(
        (motion_compensate<F, kSide>(frame, kWeights, cache[0], cache[1], memory[0], memory[1], motion, compensated)),
        last);
    for (int key = 0; key < 2; ++key) {
      EXPECT_EQ(memory[key].asked.size(), 1u);
      EXPECT_EQ(held(key), last ? 0 : 1);
    }
  }
}

}  // namespace
}  // namespace halfspace::tests
