// SPDX-License-Identifier: Apache-2.0
// ztest_merge against a model of its own, pixel by pixel, and what makes a merge one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>

#include "ref/error.hpp"
#include "tests/objects/merge_model.hpp"
#include "vectors/frames/merge_frames.hpp"

namespace halfspace::tests {
namespace {

using model::MergeInput;
using model::Merger;
using model::MergeResult;
using model::NamedMerge;
using model::RawEntry;
using ref::Box;
using Buffer = std::vector<RawEntry>;

struct Numbers {
  const char* base;
  int depth_bits, colour_bits, object_bits;
};
constexpr Numbers kNumbers[] = {
    {"low", 5, 3, 1}, {"low", 16, 8, 4}, {"middle", 24, 8, 16}, {"high", 24, 8, 22}, {"low", 32, 8, 16}};

model::Configuration configuration(const Numbers& n) {
  Config config = model::find_configuration(n.base).config();
  config.colour_bits = n.colour_bits;
  config.object_bits = n.object_bits;
  if (n.depth_bits == 32) config.reciprocal_bits = 34, config.depth_fraction = 14;
  config.depth_bits = n.depth_bits;
  return model::Configuration("merge", config);
}

TEST(ZtestMerge, IsItsDefinition) {
  std::uint64_t runs = 0, kept = 0, taken = 0, erased = 0;
  for (const Numbers& numbers : kNumbers) {
    const model::Configuration configuration = tests::configuration(numbers);
    const std::uint32_t full = std::uint32_t((std::uint64_t(1) << numbers.depth_bits) - 1);
    const std::vector<NamedMerge> frames = model::merge_frames(configuration.config(), 3);
    for (const int lanes : {1, 2, 4, 8, 16}) {
      const Merger merger(configuration, lanes);
      for (const NamedMerge& frame : frames) {
        const MergeInput in = frame.input();
        const Expected want = expected(in, full, lanes);
        const MergeResult got = merger.run(in);
        ASSERT_EQ(got.count, want.count) << frame.note << ", " << lanes << " lanes";
        ASSERT_TRUE(got.box.x0 == want.box.x0 && got.box.y0 == want.box.y0 && got.box.x1 == want.box.x1 &&
                    got.box.y1 == want.box.y1)
            << frame.note;
        ASSERT_EQ(got.cycles, want.cycles) << frame.note;
        ASSERT_EQ(got.merged.empty(), !frame.sends);
        ASSERT_TRUE(!frame.sends || got.merged == want.merged) << frame.note << ", " << lanes << " lanes";
        ++runs;
        erased += frame.sends ? want.count : 0;
        for (std::size_t at = 0; frame.sends && in.drawn && frame.width <= 64 && at < want.merged.size(); ++at) {
          if (frame.stored[at] == frame.drawn[at]) continue;
          kept += want.merged[at] == frame.stored[at], taken += want.merged[at] == frame.drawn[at];
        }
      }
    }
  }
  std::printf("%lu runs; of pixels that differ %lu kept, %lu taken; %lu erased\n", runs, kept, taken, erased);
  EXPECT_GT(runs, 2500u);
  EXPECT_GT(kept, 30000u);
  EXPECT_GT(taken, 30000u);
  EXPECT_GT(erased, 10000u);
}

// Buffers as drawing makes them: a colour follows from the key, and no fragment has full depth.
class Buffers {
 public:
  static constexpr int kWidth = 23, kHeight = 18;
  explicit Buffers(std::uint64_t seed) : random_(seed) {}
  int below(int n) { return int(random_() % std::uint64_t(n)); }
  Buffer any() {
    Buffer out;
    for (int n = 0; n < kWidth * kHeight; ++n) {
      const auto depth = std::uint32_t(below(5)), object = std::uint32_t(1 + below(6));
      out.push_back(below(3) == 0 ? RawEntry{31, 0, {1, 2, 3}}
                                  : RawEntry{depth, object, {std::uint8_t(depth), std::uint8_t(object), 7}});
    }
    return out;
  }

 private:
  std::mt19937_64 random_;
};

class Properties : public testing::TestWithParam<int> {
 protected:
  MergeInput input(const Buffer& stored, const Buffer* drawn) const {
    MergeInput in;
    in.width = Buffers::kWidth, in.height = Buffers::kHeight;
    in.box = {0, 0, in.width, in.height};
    in.stored = &stored, in.drawn = drawn;
    in.background = {1, 2, 3};
    return in;
  }
  Buffer merged(const Buffer& a, const Buffer& b) const { return merger_.run(input(a, &b)).merged; }

  const Merger merger_{configuration({"low", 5, 3, 4}), GetParam()};
};
INSTANTIATE_TEST_SUITE_P(Lanes, Properties, testing::Values(1, 2, 4, 8, 16));

TEST_P(Properties, OrderIsOfNoMatter) {
  Buffers make(5);
  for (int n = 0; n < 20; ++n) {
    std::array<Buffer, 3> buffers{make.any(), make.any(), make.any()};
    const Buffer first = merged(merged(buffers[0], buffers[1]), buffers[2]);
    ASSERT_TRUE(first == merged(buffers[0], merged(buffers[1], buffers[2])));
    std::array<int, 3> order{0, 1, 2};
    while (std::next_permutation(order.begin(), order.end())) {
      ASSERT_TRUE(first == merged(merged(buffers[std::size_t(order[0])], buffers[std::size_t(order[1])]),
                                  buffers[std::size_t(order[2])]));
    }
    ASSERT_TRUE(merged(first, buffers[1]) == first) << "what is there comes again";
    ASSERT_TRUE(merged(first, first) == first);
    const Buffer nothing(first.size(), RawEntry{31, 0, {1, 2, 3}});
    ASSERT_TRUE(merged(first, nothing) == first && merged(nothing, first) == first);
  }
}

TEST_P(Properties, EqualKeysLeaveWhatIsStored) {
  Buffers make(9);
  const Buffer stored = make.any();
  Buffer drawn = stored;
  for (RawEntry& e : drawn) e.rgb = {6, 6, 6};
  const Buffer got = merged(stored, drawn);
  for (std::size_t at = 0; at < got.size(); ++at)
    ASSERT_TRUE(got[at] == (stored[at].object == 0 ? drawn[at] : stored[at]));
}

TEST_P(Properties, WhatIsErasedIsNotFound) {
  Buffers make(11);
  std::uint64_t found = 0;
  for (int n = 0; n < 20; ++n) {
    const Buffer stored = make.any(), drawn = make.any();
    MergeInput query = input(stored, nullptr);
    query.first = std::uint32_t(1 + make.below(6)), query.last = query.first + std::uint32_t(make.below(3));
    query.sends = false;
    const MergeResult asked = merger_.run(query);
    MergeInput erase = query;
    erase.sends = true;
    const MergeResult erased = merger_.run(erase);
    ASSERT_EQ(erased.count, asked.count);
    MergeInput again = query;
    again.stored = &erased.merged;
    ASSERT_EQ(merger_.run(again).count, 0u);
    // In the box that was found it is the same, and with what is drawn as in two steps.
    MergeInput boxed = erase;
    boxed.box = asked.box;
    ASSERT_TRUE(merger_.run(boxed).merged == erased.merged);
    MergeInput both = erase;
    both.drawn = &drawn;
    ASSERT_TRUE(merger_.run(both).merged == merged(erased.merged, drawn));
    found += asked.count;
  }
  EXPECT_GT(found, 1000u);
}

// Stamps are independent: boxes that share none give the whole.
TEST_P(Properties, BoxesAddUp) {
  Buffers make(13);
  const auto [w, h] = stamp_of(GetParam());
  const Buffer stored = make.any(), drawn = make.any();
  MergeInput whole = input(stored, &drawn);
  whole.first = 2, whole.last = 4;
  const MergeResult want = merger_.run(whole);
  Buffer got = stored;
  std::uint64_t count = 0;
  for (int y = 0; y < Buffers::kHeight; y += 2 * h) {
    for (int x = 0; x < Buffers::kWidth; x += 3 * w) {
      MergeInput part = whole;
      part.stored = &got;
      part.box = Box{x, y, x + 3 * w, y + 2 * h}.cut({0, 0, whole.width, whole.height});
      const MergeResult result = merger_.run(part);
      got = result.merged;
      count += result.count;
    }
  }
  EXPECT_TRUE(got == want.merged);
  EXPECT_EQ(count, want.count);
  EXPECT_GT(count, 0u);
}

TEST(Merger, RefusesWhatDoesNotFit) {
  const Merger merger(configuration({"low", 5, 3, 4}), 4);
  EXPECT_THROW(Merger(model::find_configuration("low"), 4), ref::Error);
  EXPECT_THROW(Merger(configuration({"low", 5, 3, 4}), 3), ref::Error);
  Buffers make(1);
  const Buffer stored = make.any(), drawn = make.any();
  MergeInput good;
  good.width = Buffers::kWidth, good.height = Buffers::kHeight;
  good.box = {0, 0, 5, 5};
  good.stored = &stored, good.drawn = &drawn;
  EXPECT_NO_THROW(merger.run(good));
  const auto refused = [&](auto change) {
    MergeInput bad = good;
    change(bad);
    EXPECT_THROW(merger.run(bad), ref::Error);
  };
  refused([](MergeInput& in) { in.box.x1 = in.box.x0; });
  refused([](MergeInput& in) { in.box.x1 = in.width + 1; });
  refused([](MergeInput& in) { in.last = 16; });
  refused([](MergeInput& in) { in.width = 1000; });
  refused([](MergeInput& in) { in.height -= 1; });
  refused([](MergeInput& in) { in.stored = nullptr; });
  Buffer deep = stored;
  deep[3].depth = 32;
  refused([&](MergeInput& in) { in.drawn = &deep; });
}

}  // namespace
}  // namespace halfspace::tests
