// SPDX-License-Identifier: Apache-2.0
// index_pool against the rule of ref::IndexPool, frame after frame, and in the pipeline: the indices, pictures and the
// largest index are those of a host that gives them by the same rule.
#include "hls/ztest/index_pool.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>

#include "hls/formats/formats.hpp"
#include "model/formats/field_value.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/raster/index_pool.hpp"
#include "vectors/frames/index_frames.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

template <int kIndices, int kWindow>
struct Pooled {
  static constexpr Config config() {
    Config c{"pooled", 160, 120, kIndices, 9, 6, 18, 8, 20, 12, 14, 4, Shading::kGouraud};
    c.index_window = kWindow;
    return c;
  }
};

// Random results; those of a frame arrive while later frames are drawn.
template <int kIndices, int kWindow>
void expect_rule(std::uint64_t seed) {
  using F = Formats<Pooled<kIndices, kWindow>, Stamp4>;
  std::mt19937_64 random(seed);
  PoolRegisters<F> registers{};
  Stream<UnnumberedTriangle<F>> triangle;
  Stream<Visible<F>> returned;
  Stream<Triangle<F>> numbered;
  int without = 0, again = 0;
  for (int frame = 0; frame < 60; ++frame) {
    ref::IndexPool rule({kWindow, kIndices});
    const int count = 1 + int(random() % (3 * kWindow + 8)), visible_of_8 = int(random() % 9);
    std::uint32_t largest = 0;
    for (int n = 0; n < count; ++n) {
      UnnumberedTriangle<F> in{};
      in.last = from_raw<Bit>(n + 1 == count);
      for (int v = 0; v < 3; ++v)
        in.x[v] = from_raw<typename F::Coord>(v), in.y[v] = from_raw<typename F::Coord>(v + 5);
      triangle.write(in);
      EXPECT_EQ(index_pool(triangle, returned, registers, numbered), n + 1 == count);
      const Triangle<F> out = numbered.read();
      const std::uint32_t index = std::uint32_t(raw(out.index)), expected = rule.take_or_none();
      ASSERT_EQ(index, expected) << "frame " << frame << ", triangle " << n;
      EXPECT_EQ(raw(out.y[2]), index == 0 ? 0 : 7);
      EXPECT_EQ(raw(out.x[2]), 2);
      EXPECT_EQ(raw(out.last), n + 1 == count);
      again += index != 0 && index <= largest;
      without += index == 0;
      largest = std::max(largest, index);
      Visible<F> done{};
      done.last = out.last;
      done.index = out.index;
      done.visible = from_raw<Bit>(index != 0 && int(random() % 8) < visible_of_8);
      returned.write(done);
      rule.done(index, raw(done.visible) != 0);
    }
    EXPECT_EQ(largest, rule.largest());
  }
  EXPECT_GT(again, 20);
  EXPECT_EQ(without > 20, kIndices < 100);
}

TEST(IndexPool, FollowsTheRule) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    expect_rule<100, 1>(seed);
    expect_rule<100, 7>(seed);
    expect_rule<20, 16>(seed);
    expect_rule<9, 16>(seed);
    expect_rule<2, 5>(seed);
  }
}

Config with_window(int triangles, int window) {
  Config c = model::find_configuration("low").config();
  c.triangles = triangles, c.index_window = window;
  return c;
}

struct Seen {
  std::vector<std::int64_t> visible, index;
  bool operator==(const Seen& other) const { return visible == other.visible && index == other.index; }
  std::int64_t largest() const { return *std::max_element(index.begin(), index.end()); }
};
Seen seen(model::Engine& engine, const ref::SnappedList& list) {
  Seen out;
  engine.capture(list, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
    if (layout.stream != "visible") return;
    for (std::size_t n = 0; n < count; ++n) {
      out.visible.push_back(model::field_value(words[n], model::field_named(layout, "visible")));
      out.index.push_back(model::field_value(words[n], model::field_named(layout, "index")));
    }
  });
  return out;
}

ref::SnappedList castle(ref::RasterFormat format) {
  format.triangles = 1 << 20;
  return ref::snap(ref::project(ref::load_scene("castle"), ref::frame_view(format, 160, 120)), format);
}

TEST(IndexPool, GivesWhatAHostGives) {
  for (const int window : {1, 24, 300}) {
    const Config pooled = with_window(4000, window);
    Config plain = pooled;
    plain.index_window = 0;
    const auto ours = model::make_engine(model::Configuration("pooled", pooled), 4);
    const auto theirs = model::make_engine(model::Configuration("plain", plain), 4);
    theirs->reuse_indices(window);
    const ref::SnappedList list = castle(model::raster_format(model::Configuration("pooled", pooled)));
    for (int frame = 0; frame < 2; ++frame) {
      EXPECT_EQ(ours->render(list).colour, theirs->render(list).colour);
      const Seen mine = seen(*ours, list);
      EXPECT_TRUE(mine == seen(*theirs, list)) << "window " << window;
      // As many as triangles are visible, and the window at most; the room that the same frame then takes.
      const std::int64_t visible = std::count(mine.visible.begin(), mine.visible.end(), 1);
      EXPECT_LE(mine.largest(), visible + window);
      const auto tight = model::make_engine(model::Configuration("tight", with_window(int(mine.largest()), window)), 4);
      EXPECT_EQ(tight->render(list).colour, theirs->render(list).colour);
    }
  }
}

TEST(IndexPool, RunsOutInADefinedWay) {
  const model::Configuration configuration("pooled", with_window(50, 6));
  const auto engine = model::make_engine(configuration, 4);
  const auto frames = model::index_frames(model::raster_format(configuration), configuration.config());
  int ran_out = 0;
  for (const model::NamedFrame& frame : frames) {
    const Seen all = seen(*engine, frame.scene);
    const bool lacks = std::count(all.index.begin(), all.index.end(), 0) != 0;
    for (std::size_t k = 0; k < all.index.size(); ++k) EXPECT_LE(all.visible[k], all.index[k]);
    if (lacks) {
      ++ran_out;
      EXPECT_THROW(model::make_engine(configuration, 4)->render(frame.scene), ref::Error) << frame.note;
    }
  }
  EXPECT_EQ(ran_out, 2);
}

// A pass of a sequence takes the triangles that there are indices for, and the next one finds the registers as new.
TEST(IndexPool, FitsAsManyAsTheRule) {
  const int window = 8;
  Config plain = with_window(300, 0);
  const auto ours = model::make_engine(model::Configuration("pooled", with_window(300, window)), 4);
  const auto theirs = model::make_engine(model::Configuration("plain", plain), 4);
  theirs->reuse_indices(window);
  ref::SnappedList list = castle(model::raster_format(model::Configuration("plain", plain)));
  const std::size_t first = ours->fits(list);
  EXPECT_EQ(first, theirs->fits(list));
  EXPECT_LT(first, list.triangles.size());
  list.triangles.resize(first);
  EXPECT_EQ(ours->render(list).colour, theirs->render(list).colour);
}

}  // namespace
}  // namespace halfspace::tests
