// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/merge_frames.hpp"

#include <algorithm>
#include <random>
#include <utility>

#include "ref/geometry/snap.hpp"

namespace halfspace::model {
namespace {

class Maker {
 public:
  Maker(const Config& config, std::uint64_t seed)
      : c_(config), most_((1u << config.object_bits) - 1), full_(ref::full_depth(config.depth_bits)), random_(seed) {}

  int below(int n) { return int(random_() % std::uint64_t(n)); }
  bool one_in(int n) { return below(n) == 0; }
  std::uint32_t most() const { return most_; }
  std::uint32_t full() const { return full_; }
  // A number that there is: 1, 2, …, and from the largest on 1 again.
  std::uint32_t object(std::uint32_t n) const { return 1 + (n - 1) % most_; }
  std::uint32_t some_object() { return one_in(8) ? most_ : object(std::uint32_t(1 + below(6))); }

  // Few depths, so that they meet, their ends among them.
  std::uint32_t some_depth() {
    const std::uint32_t depths[] = {0, 1, full_ / 2, full_ / 2 + 1, full_ - 1, full_};
    return one_in(6) ? std::uint32_t(random_()) & full_ : depths[below(6)];
  }

  std::array<std::uint8_t, 3> some_colour() {
    std::array<std::uint8_t, 3> out;
    for (auto& channel : out) channel = std::uint8_t(below(1 << c_.colour_bits));
    return out;
  }

  // One entry in `empty` is background; 0: none is.
  std::vector<RawEntry> buffer(const NamedMerge& run, int empty) {
    std::vector<RawEntry> out(std::size_t(run.width) * run.height);
    for (RawEntry& e : out) {
      e = empty != 0 && one_in(empty) ? RawEntry{full_, 0, run.background}
                                      : RawEntry{some_depth(), some_object(), some_colour()};
    }
    return out;
  }

  // Over the whole frame, of an S-buffer that one in three pixels is empty in; nothing is drawn.
  NamedMerge run(const std::string& note, int width, int height) {
    NamedMerge out;
    out.note = note;
    out.width = std::min(width, c_.width), out.height = std::min(height, c_.height);
    out.box = {0, 0, out.width, out.height};
    out.background = some_colour();
    out.stored = buffer(out, 3);
    return out;
  }
  NamedMerge merge(const std::string& note, int width, int height) {
    NamedMerge out = run(note, width, height);
    out.drawn = buffer(out, 3);
    return out;
  }
  NamedMerge erase(const std::string& note, std::uint32_t first, std::uint32_t last) {
    NamedMerge out = run(note, 22, 17);
    out.first = first, out.last = last;
    return out;
  }
  NamedMerge query(const std::string& note, std::uint32_t first, std::uint32_t last) {
    NamedMerge out = erase(note, first, last);
    out.sends = false;
    return out;
  }
  // `change` makes the drawn pixel of the stored one. Colours differ, so that it shows whose pixel stays.
  template <class Change>
  NamedMerge changed(const std::string& note, Change change) {
    NamedMerge out = run(note, 19, 14);
    out.stored = buffer(out, 0);
    out.drawn = out.stored;
    for (RawEntry& e : out.drawn) change(e), e.rgb = some_colour();
    return out;
  }
  void choose_box(NamedMerge& run) {
    const int x0 = below(run.width), y0 = below(run.height);
    run.box = {x0, y0, x0 + 1 + below(run.width - x0), y0 + 1 + below(run.height - y0)};
  }

  // Any of all that a run can be.
  NamedMerge any(const std::string& note, int most_side) {
    NamedMerge out = run(note, 1 + below(most_side), 1 + below(most_side));
    choose_box(out);
    if (!one_in(4)) out.drawn = buffer(out, 1 + below(4));
    out.sends = !one_in(4);
    if (!one_in(3)) out.first = std::uint32_t(below(5)), out.last = some_object();
    return out;
  }

 private:
  const Config c_;
  const std::uint32_t most_, full_;
  std::mt19937_64 random_;
};

void add_keys(Maker& make, std::vector<NamedMerge>& runs) {
  runs.push_back(make.changed("equal depths, the lesser object is drawn",
                              [&](RawEntry& e) { e.object = std::max(e.object, 2u) - 1; }));
  runs.push_back(make.changed("equal keys", [](RawEntry&) {}));
  runs.push_back(make.changed("equal depths, the greater object is drawn",
                              [&](RawEntry& e) { e.object = std::min(e.object + 1, make.most()); }));
  runs.push_back(make.changed("nearer by one, of the greatest object", [&](RawEntry& e) {
    e = {std::max(e.depth, 1u) - 1, make.most(), {}};
  }));
  runs.push_back(make.changed("farther by one, of the least object", [&](RawEntry& e) {
    e = {std::min(e.depth, make.full() - 1) + 1, 1, {}};
  }));
  runs.push_back(make.merge("full depth", 20, 13));
  for (auto* buffer : {&runs.back().stored, &runs.back().drawn}) {
    for (RawEntry& e : *buffer) e.depth = make.full();
  }
  runs.push_back(make.merge("nothing stored", 18, 12));
  runs.back().stored.assign(runs.back().stored.size(), {make.full(), 0, runs.back().background});
  runs.push_back(make.merge("nothing drawn", 18, 12));
  runs.back().drawn.assign(runs.back().drawn.size(), {make.full(), 0, make.some_colour()});
  runs.push_back(make.merge("neither stored nor drawn", 9, 9));
  runs.back().stored.assign(runs.back().stored.size(), {make.full(), 0, runs.back().background});
  runs.back().drawn = runs.back().stored;
}

void add_ranges(Maker& make, std::vector<NamedMerge>& runs) {
  runs.push_back(make.erase("erase one", 2, 2));
  runs.push_back(make.erase("erase the greatest", make.most(), make.most()));
  runs.push_back(make.erase("erase all", 1, make.most()));
  runs.push_back(make.erase("erase some", 2, 4));
  runs.push_back(make.erase("erase none", 3, 2));
  runs.push_back(make.erase("erase what there is not", 8, 9));
  runs.push_back(make.erase("a range from 0", 0, 2));
  runs.push_back(make.erase("a range of 0 alone", 0, 0));
  runs.push_back(make.query("query of one", 1, 1));
  runs.push_back(make.query("query of all", 1, make.most()));
  runs.push_back(make.query("query of what there is not", 9, 9));
  runs.push_back(make.query("query without a range", 1, 0));
  for (const int corner : {0, 1, 2, 3}) {
    NamedMerge run = make.query("query of one pixel", 1, 1);
    for (RawEntry& e : run.stored) e.object = e.object == 1 ? 0 : e.object;
    for (RawEntry& e : run.stored) e.depth = e.object == 0 ? make.full() : e.depth;
    const int x = corner % 2 ? run.width - 1 : 0, y = corner / 2 ? run.height - 1 : 0;
    run.stored[std::size_t(y) * run.width + x] = {make.full() / 3, 1, make.some_colour()};
    runs.push_back(run);
  }
  runs.push_back(make.merge("erase and merge", 21, 16));
  runs.back().first = 1, runs.back().last = 3;
  runs.push_back(make.changed("erase, and merge what is farther", [&](RawEntry& e) {
    e = {std::min(e.depth, make.full() - 1) + 1, make.most(), {}};
  }));
  runs.back().first = 1, runs.back().last = make.most();
  runs.push_back(make.merge("merge, and send nothing", 21, 16));
  runs.back().first = 2, runs.back().last = 5;
  runs.back().sends = false;
}

// The largest frame is that of its last stamps, and, where there are few enough for a file, of all.
void add_sizes(const Config& config, Maker& make, std::vector<NamedMerge>& runs) {
  runs.push_back(make.merge("a single pixel", 1, 1));
  runs.push_back(make.merge("a row", 37, 1));
  runs.push_back(make.merge("a column", 1, 37));
  runs.push_back(make.merge("whole stamps", 32, 16));
  runs.push_back(make.merge("a box of one stamp", 31, 27));
  runs.back().box = {runs.back().width / 2, runs.back().height / 2, runs.back().width / 2 + 1,
                     runs.back().height / 2 + 1};
  runs.push_back(make.merge("the last stamps of the largest frame", config.width, config.height));
  NamedMerge& last = runs.back();
  last.box = {std::max(last.width - 9, 0), std::max(last.height - 7, 0), last.width, last.height};
  last.first = 1, last.last = make.most();
  constexpr int kMostPixels = 1 << 19;
  if (config.width * config.height <= kMostPixels) {
    runs.push_back(make.run("one object over all of the largest frame", config.width, config.height));
    for (RawEntry& e : runs.back().stored) e = {make.full() / 2, make.most(), runs.back().background};
    runs.back().first = runs.back().last = make.most();
    runs.back().sends = false;
  }
}

}  // namespace

std::vector<NamedMerge> merge_frames(const Config& config, std::uint64_t seed) {
  Maker make(config, seed);
  std::vector<NamedMerge> runs;
  add_keys(make, runs);
  add_ranges(make, runs);
  add_sizes(config, make, runs);
  for (int n = 0; n < 24; ++n) runs.push_back(make.any("short", 5));
  for (int n = 0; n < 60; ++n) runs.push_back(make.any("random", 40));
  for (NamedMerge& run : runs)
    run.first = std::min(run.first, make.most()), run.last = std::min(run.last, make.most());  // as there are
  return runs;
}

}  // namespace halfspace::model
