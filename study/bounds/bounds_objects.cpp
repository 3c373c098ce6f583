// SPDX-License-Identifier: Apache-2.0
// ztest_merge held to 64-bit keys.
#include <random>

#include "model/objects/merge.hpp"
#include "study/bounds/bounds_measure.hpp"

namespace halfspace::model {
namespace {

std::uint64_t key_of(const RawEntry& e) { return ref::object_key(e.depth, e.object); }

// Entries whose depths and objects are often equal; background among them.
std::vector<RawEntry> random_entries(std::mt19937_64& random, std::size_t count, const Config& c) {
  const std::uint32_t most = (1u << c.object_bits) - 1, farthest = ref::full_depth(c.depth_bits);
  const auto below = [&](std::uint32_t n) { return std::uint32_t(random() % (std::uint64_t(n) + 1)); };
  std::vector<RawEntry> entries(count);
  for (RawEntry& e : entries) {
    e.object = random() % 4 == 0 ? 0 : random() % 2 ? 1 + below(std::min(most, 4u) - 1) : 1 + below(most - 1);
    e.depth = e.object == 0 ? farthest : random() % 2 ? std::min(farthest - 1, below(3)) : below(farthest - 1);
    for (auto& channel : e.rgb) channel = std::uint8_t(below((1u << c.colour_bits) - 1));
  }
  return entries;
}

}  // namespace

void measure_merges(const Configuration& configuration, std::uint64_t seed, BoundsReport& report) {
  const Config c = configuration.config();
  const Merger merger(configuration, c.lanes);
  std::mt19937_64 random(seed);
  const int width = std::min(c.width, 61), height = std::min(c.height, 33);
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  const std::uint32_t most = (1u << c.object_bits) - 1;
  for (std::uint64_t number = 1; number <= 20; ++number) {
    const std::vector<RawEntry> stored = random_entries(random, pixels, c), drawn = random_entries(random, pixels, c);
    MergeInput input{width, height, {0, 0, width, height}, &stored, &drawn};
    input.first = 1 + std::uint32_t(random() % most),
    input.last = std::min<std::uint32_t>(most, input.first + number % 3);
    input.background = {std::uint8_t((1 << c.colour_bits) - 1), 0, 1};
    const RawEntry background{ref::full_depth(c.depth_bits), 0, input.background};
    const MergeResult result = merger.run(input);
    std::uint64_t found = 0;
    for (std::size_t n = 0; n < pixels; ++n) {
      const bool hit = stored[n].object >= input.first && stored[n].object <= input.last;
      found += hit;
      const RawEntry& kept = hit ? background : stored[n];
      const RawEntry& nearer = kept.object == 0 || key_of(drawn[n]) < key_of(kept) ? drawn[n] : kept;
      BoundRow& row = report.rows[kMerge];
      if (row.count(1, !(result.merged[n] == nearer)))
        row.where = {"random entries", number, false, {}, int(n) % width, int(n) / width};
    }
    BoundRow& row = report.rows[kMergeFound];
    if (row.count(1, result.count != found)) row.where = {"random entries", number};
  }
}

}  // namespace halfspace::model
