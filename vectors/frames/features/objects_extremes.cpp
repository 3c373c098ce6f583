// SPDX-License-Identifier: Apache-2.0
// Extremes of objects: their numbers in a frame, and keys, ranges and counts of ztest_merge.
#include <algorithm>
#include <string>

#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/features/light_builder.hpp"

namespace halfspace::model {
namespace {

// Entries of one run, a pixel each.
class Runs {
 public:
  explicit Runs(const Config& config)
      : c_(config), most_((1u << config.object_bits) - 1), full_(ref::full_depth(config.depth_bits)) {}

  std::uint32_t most() const { return most_; }
  std::uint32_t top() const { return (most_ + 1) / 2; }  // the top bit alone
  std::uint32_t full() const { return full_; }

  NamedMerge run(const std::string& note, int width, int height) const {
    NamedMerge out;
    out.note = "extreme: " + note;
    out.width = std::min(width, c_.width), out.height = std::min(height, c_.height);
    out.box = {0, 0, out.width, out.height};
    out.background = {0, 0, std::uint8_t((1 << c_.colour_bits) - 1)};
    out.stored.assign(std::size_t(out.width) * out.height, {full_, 0, out.background});
    return out;
  }
  // put(n, stored, drawn) makes both entries of pixel n, in colours that tell them apart.
  template <class Put>
  NamedMerge merge(const std::string& note, Put put) const {
    NamedMerge out = run(note, 16, 12);
    out.drawn = out.stored;
    const std::uint8_t white = std::uint8_t((1 << c_.colour_bits) - 1);
    for (std::size_t n = 0; n < out.stored.size(); ++n) {
      out.stored[n].rgb = {white, 0, 0}, out.drawn[n].rgb = {0, white, 0};
      put(std::uint32_t(n), out.stored[n], out.drawn[n]);
    }
    return out;
  }

 private:
  const Config c_;
  const std::uint32_t most_, full_;
};

}  // namespace

std::vector<NamedFrame> object_extremes(const ref::RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const Runs runs(config);
  const int cells = std::min(format.triangles, 150);
  push_cells(frames, "extreme: objects 1, the last one, and those that the top bit alone tells apart", format, cells, 3,
             {}, [&](NamedFrame& frame, int k, Point) {
               const std::uint32_t numbers[6] = {
                   1, runs.most(), runs.top(), runs.most() - 1, runs.top() | 1, runs.most() / 2};
               frame.objects.push_back(std::max(numbers[k % 6], 1u));
             });
  return frames;
}

std::vector<NamedMerge> merge_extremes(const Config& config) {
  const Runs runs(config);
  const std::uint32_t full = runs.full(), most = runs.most(), top = runs.top();
  std::vector<NamedMerge> out;
  out.push_back(
      runs.merge("equal keys in every pixel: what is stored stays", [&](std::uint32_t n, RawEntry& s, RawEntry& d) {
        s.depth = d.depth = n % 3 == 0 ? 0 : n % 3 == 1 ? full : full / 2;
        s.object = d.object = n % 2 ? most : 1;
      }));
  out.push_back(runs.merge("equal depths of objects that the top bit alone tells apart",
                           [&](std::uint32_t n, RawEntry& s, RawEntry& d) {
                             s.depth = d.depth = n % 2 ? full : 0;
                             const std::uint32_t low = std::max(n / 4 % top, 1u), high = low | top;
                             s.object = n / 2 % 2 ? low : high, d.object = n / 2 % 2 ? high : low;
                           }));
  out.push_back(runs.merge("depths an LSB apart, or the top bit, of the last object and the first",
                           [&](std::uint32_t n, RawEntry& s, RawEntry& d) {
                             const std::uint32_t apart = n % 2 ? 1 : full / 2 + 1, low = n / 4 % 2 ? 0 : full - apart;
                             s.depth = low, d.depth = low + apart;
                             if (n / 2 % 2) std::swap(s.depth, d.depth);
                             s.object = n % 3 ? most : 1, d.object = n % 3 ? 1 : most;
                           }));
  out.push_back(runs.merge("full tables: every number in turn, at full depth, and nothing stored or drawn",
                           [&](std::uint32_t n, RawEntry& s, RawEntry& d) {
                             s.object = n % 5 == 0 ? 0 : 1 + n % most;
                             d.object = n % 7 == 0 ? 0 : most - n % most;
                           }));
  const struct {
    std::uint32_t first, last;
  } ranges[] = {{most, most}, {1, most}, {top, most}, {1, std::max(top, 2u) - 1}, {1, 1}, {most, 1}, {0, 0}, {0, most}};
  for (const auto& range : ranges) {
    for (const bool sends : {true, false}) {
      NamedMerge run =
          runs.merge("objects " + std::to_string(range.first) + " to " + std::to_string(range.last) +
                         (sends ? " are erased" : " are asked for"),
                     [&](std::uint32_t n, RawEntry& s, RawEntry&) {
                       const std::uint32_t numbers[8] = {0, 1, most, top, std::max(top, 2u) - 1, top | 1, most - 1, 1};
                       s.object = numbers[n % 8];
                       if (s.object != 0) s.depth = n * 37 % full;
                     });
      run.drawn.clear();
      run.first = range.first, run.last = range.last, run.sends = sends;
      out.push_back(run);
    }
  }
  out.push_back(runs.run("a single pixel, of the last object", 1, 1));
  out.back().stored[0] = {0, most, {0, 0, 0}}, out.back().first = 1, out.back().last = most;
  return out;
}

NamedMerge largest_merge(const Config& config) {
  const Runs runs(config);
  NamedMerge out = runs.run("a whole buffer of the last object: the largest count", config.width, config.height);
  for (RawEntry& entry : out.stored) entry = {0, runs.most(), {0, 0, 0}};
  out.first = out.last = runs.most();
  out.sends = false;
  return out;
}

}  // namespace halfspace::model
