// SPDX-License-Identifier: Apache-2.0
// Units of objects on the largest frame of a configuration, which takes every turn that a loop has: what scan_object
// gives by stamps, and where static_run puts stamps that ztest_merge is to see, or has merged.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <tuple>

#include "hls/objects/scan_object.hpp"
#include "hls/objects/static_run.hpp"
#include "hls/objects/ztest_merge.hpp"
#include "tests/formats/record_fields.hpp"

namespace halfspace::tests {
namespace {

struct Small {
  static constexpr Config config() {
    Config config = {"small", 13, 11, 30, 6, 1, 4, 3, 10, 8, 8, 4, Shading::kGouraud};
    config.object_bits = 3;
    return config;
  }
};
using F = Formats<Small, Stamp4>;

class WholeFrame : public testing::Test {
 protected:
  template <class T>
  T any() {
    T word{};
    word.visit(Randomize{bits_});
    return word;
  }
  // The places of a box, row by row.
  template <class T>
  static void put_place(T& word, int n, const StaticCommand<F>& run) {
    const int x0 = int(raw(run.x_first)), width = int(raw(run.x_last)) - x0 + 1, y0 = int(raw(run.y_first));
    word.x = from_raw<F::X>(x0 + n % width), word.y = from_raw<F::Y>(y0 + n / width);
  }
  static StaticCommand<F> box(int x0, int y0, int x1, int y1) {
    StaticCommand<F> run{};
    run.x_first = from_raw<F::X>(x0), run.x_last = from_raw<F::X>(x1);
    run.y_first = from_raw<F::Y>(y0), run.y_last = from_raw<F::Y>(y1);
    run.stored = from_raw<BufferNumber<F>>(3), run.drawn = from_raw<BufferNumber<F>>(5);
    run.kept = from_raw<BufferNumber<F>>(6);
    run.r = from_raw<F::Colour>(1), run.g = from_raw<F::Colour>(4), run.b = from_raw<F::Colour>(6);
    return run;
  }
  static StaticCommand<F> whole() { return box(0, 0, F::kStampsX - 1, F::kStampsY - 1); }
  static int stamps_of(const StaticCommand<F>& run) {
    return (int(raw(run.x_last)) - int(raw(run.x_first)) + 1) * (int(raw(run.y_last)) - int(raw(run.y_first)) + 1);
  }

  std::mt19937_64 bits_{3};
};

TEST_F(WholeFrame, OfObjectsIsItsStamps) {
  const auto depths = std::make_unique<DepthBuffer<F>>();
  ObjectTable<F> table;
  for (int n = 0; n < F::kTriangles; ++n) table.object[n] = from_raw<F::Object>(n % 7 + 1);
  Stream<Scan<F>> scan_one, scan_whole;
  Stream<ObjectPixel<F>> one, whole_frame;
  for (int n = 0; n < F::kStamps; ++n) {
    Scan<F> word{};
    put_place(word, n, whole());
    word.last = from_raw<Bit>(n + 1 == F::kStamps);
    for (int l = 0; l < F::kLanes; ++l) {
      word.index[l] = from_raw<F::Index>(bits_() % 5);
      depths->depth[n][l] = from_raw<F::Depth>(bits_());
    }
    scan_one.write(word), scan_whole.write(word);
  }
  for (int n = 0; n < F::kStamps; ++n) EXPECT_EQ(scan_object(scan_one, *depths, table, one), n + 1 == F::kStamps);
  scan_object_frame(scan_whole, *depths, table, whole_frame);
  EXPECT_TRUE(scan_whole.empty());
  const std::vector<std::int64_t> pixels = drain(one);
  EXPECT_EQ(pixels.size(), std::size_t(F::kStamps * (3 + 2 * F::kLanes)));
  EXPECT_EQ(drain(whole_frame), pixels);
}

// Buffers that have other pixels in each place.
struct Memory {
  std::map<std::tuple<int, int, int>, StampPixels<F>> stamps;
  std::vector<KeptStamp<F>> kept;
  int stored_reads = 0, drawn_reads = 0;

  static std::tuple<int, int, int> at(const BufferPlace<F>& place) {
    return {int(raw(place.buffer)), int(raw(place.x)), int(raw(place.y))};
  }
  StampPixels<F> read_stored(const BufferPlace<F>& place) { return ++stored_reads, stamps.at(at(place)); }
  StampPixels<F> read_drawn(const BufferPlace<F>& place) { return ++drawn_reads, stamps.at(at(place)); }
  void keep(const KeptStamp<F>& stamp) { kept.push_back(stamp); }
};

TEST_F(WholeFrame, OfStampsIsFetched) {
  Memory memory;
  for (const int buffer : {3, 5}) {
    for (int n = 0; n < F::kStamps; ++n)
      memory.stamps[{buffer, n % F::kStampsX, n / F::kStampsX}] = any<StampPixels<F>>();
  }
  for (const auto& base : {whole(), box(1, 2, 4, 3), box(2, 1, 2, 1), box(0, 0, 5, 0)}) {
    for (int mode = 0; mode < 8; ++mode) {
      StaticCommand<F> run = base;
      run.anew = from_raw<Bit>(mode), run.merges = from_raw<Bit>(mode >> 1), run.passes = from_raw<Bit>(mode >> 2);
      if (is_set(run.passes) && !is_set(run.merges)) continue;
      Stream<Entry<F>> entry, stored, drawn;
      Stream<Merge<F>> merge;
      std::vector<Entry<F>> pass(F::kStamps);
      for (int n = 0; n < F::kStamps; ++n) {
        pass[n] = any<Entry<F>>();
        put_place(pass[n], n, whole());
        pass[n].last = from_raw<Bit>(n + 1 == F::kStamps);
        if (is_set(run.passes)) entry.write(pass[n]);
      }
      memory.stored_reads = memory.drawn_reads = 0;
      static_fetch(run, memory, entry, merge, stored, drawn);
      EXPECT_TRUE(entry.empty());
      EXPECT_EQ(fields_of<Merge<F>>({merge.read()}), fields_of<Merge<F>>({run}));
      const int stamps = stamps_of(run);
      EXPECT_EQ(memory.stored_reads, is_set(run.anew) ? 0 : stamps);
      EXPECT_EQ(memory.drawn_reads, is_set(run.merges) && !is_set(run.passes) ? stamps : 0);
      for (int n = 0; n < stamps; ++n) {
        Entry<F> place{};
        put_place(place, n, run);
        const int x = int(raw(place.x)), y = int(raw(place.y));
        const auto expect = [&](Stream<Entry<F>>& stream, StampPixels<F> pixels) {
          ASSERT_FALSE(stream.empty());
          const Entry<F> got = stream.read();
          EXPECT_EQ(int(raw(got.x)), x);
          EXPECT_EQ(int(raw(got.y)), y);
          EXPECT_EQ(is_set(got.last), n + 1 == stamps);
          EXPECT_EQ(fields_of<StampPixels<F>>({pixels_of(got)}), fields_of<StampPixels<F>>({pixels}));
        };
        StampPixels<F> background{};
        for (int l = 0; l < F::kLanes; ++l) {
          background.depth[l] = from_raw<F::Depth>(15);
          background.r[l] = run.r, background.g[l] = run.g, background.b[l] = run.b;
        }
        expect(stored, is_set(run.anew) ? background : memory.stamps[{3, x, y}]);
        if (!is_set(run.merges)) continue;
        expect(drawn, is_set(run.passes) ? pixels_of(pass[y * F::kStampsX + x]) : memory.stamps[{5, x, y}]);
      }
      EXPECT_TRUE(stored.empty() && drawn.empty());
    }
  }
}

TEST_F(WholeFrame, OfStampsIsKeptOrShown) {
  for (const auto& base : {whole(), box(1, 2, 4, 3)}) {
    for (int mode = 0; mode < 4; ++mode) {
      StaticCommand<F> run = base;
      run.sends = from_raw<Bit>(mode), run.shows = from_raw<Bit>(mode >> 1);
      Memory memory;
      Stream<Entry<F>> merged, shown;
      std::vector<Entry<F>> words(stamps_of(run));
      for (std::size_t n = 0; n < words.size(); ++n) {
        words[n] = any<Entry<F>>();
        put_place(words[n], int(n), run);
        words[n].last = from_raw<Bit>(n + 1 == words.size());
        if (is_set(run.sends)) merged.write(words[n]);
      }
      static_store(run, memory, merged, shown);
      EXPECT_TRUE(merged.empty());
      const bool shows = is_set(run.sends) && is_set(run.shows), keeps = is_set(run.sends) && !is_set(run.shows);
      EXPECT_EQ(drain(shown), shows ? fields_of(words) : std::vector<std::int64_t>());
      ASSERT_EQ(memory.kept.size(), keeps ? words.size() : 0u);
      for (std::size_t n = 0; n < memory.kept.size(); ++n) {
        EXPECT_EQ(Memory::at(memory.kept[n].place), std::make_tuple(6, int(raw(words[n].x)), int(raw(words[n].y))));
        EXPECT_EQ(fields_of<StampPixels<F>>({memory.kept[n].pixels}), fields_of<StampPixels<F>>({pixels_of(words[n])}));
      }
    }
  }
}

// Each stamp is read, merged with nothing, and counted.
TEST_F(WholeFrame, OfStampsIsMerged) {
  Stream<Merge<F>> merge;
  Stream<Entry<F>> stored, entry, merged;
  Stream<Found<F>> found;
  Merge<F> run{};
  run.sends = from_raw<Bit>(1);
  run.first = from_raw<F::Object>(2), run.last = from_raw<F::Object>(2);
  merge.write(run);
  for (int n = 0; n < F::kStamps; ++n) {
    Entry<F> word = any<Entry<F>>();
    put_place(word, n, whole());
    for (auto& object : word.object) object = from_raw<F::Object>(2);
    word.last = from_raw<Bit>(n + 1 == F::kStamps);
    stored.write(word);
  }
  ztest_merge(merge, stored, entry, merged, found);
  EXPECT_TRUE(stored.empty());
  const Found<F> all = found.read();
  EXPECT_EQ(int(raw(all.count)), F::kStamps * F::kLanes);
  EXPECT_EQ(int(raw(all.x_first)), 0);
  EXPECT_EQ(int(raw(all.x_last)), F::kStampsX - 1);
  EXPECT_EQ(int(raw(all.y_first)), 0);
  EXPECT_EQ(int(raw(all.y_last)), F::kStampsY - 1);
  EXPECT_EQ(drain(merged).size(), std::size_t(F::kStamps * (3 + 5 * F::kLanes)));
}

}  // namespace
}  // namespace halfspace::tests
