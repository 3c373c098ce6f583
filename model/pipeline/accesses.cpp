// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/accesses.hpp"

#include <algorithm>
#include <string>

#include "model/formats/field_value.hpp"

namespace halfspace::model {
namespace {

class Counter {
 public:
  Counter(const Config& config, const Engine& engine, const ref::SnappedList& scene)
      : by_pixel_(is_phong(config) || has_motion(config)),
        stores_depth_(stores_depth(config)),
        tests_planes_(tests_planes(config)),
        has_objects_(has_objects(config)),
        numbered_(gives_indices(config) ? "numbered" : "triangle"),
        lanes_x_(engine.lanes_x()),
        lanes_(engine.lanes_x() * engine.lanes_y()),
        lanes_y_(engine.lanes_y()),
        width_(scene.width),
        height_(scene.height) {}

  void count(const Layout& layout, const Word* words, std::size_t number) {
    ref::BufferUses &n = out_.needed, &w = out_.words;
    const std::string& stream = layout.stream;
    if (stream == "stamp") {
      const std::uint64_t fragments = count_set(layout, words, number, "mask");
      n.index.read += fragments, w.index.read += number * lanes_;
      if (stores_depth_) n.depth.read += fragments, w.depth.read += number * lanes_;
    } else if (stream == "update") {
      const std::uint64_t passed = count_set(layout, words, number, "mask");
      n.index.written += passed, w.index.written += passed;
      if (stores_depth_) n.depth.written += passed, w.depth.written += passed;
    } else if (stream == "scan") {
      for (std::size_t k = 0; k < number; ++k) scan(layout, words[k]);
    } else if (stream == "planes" || stream == "motion_planes") {
      stored(n.shading, w.shading, number - count_set(layout, words, number, "empty"));
    } else if (has_objects_ && stream == numbered_) {
      stored(n.object, w.object, count_set(layout, words, number, "index"));
    } else if (stream == "visible" && tests_planes_) {
      stored(n.visibility, w.visibility, count_set(layout, words, number, "visible"));
    }
  }
  void fetched(std::uint64_t entries) { out_.needed.visibility.read += entries, out_.words.visibility.read += entries; }
  const Accesses& result() const { return out_; }

 private:
  static void stored(ref::BufferUse& needed, ref::BufferUse& words, std::uint64_t entries) {
    needed.written += entries, words.written += entries;
  }

  void scan(const Layout& layout, const Word& word) {
    const Field& index = field_named(layout, "index");
    const int x = int(field_value(word, field_named(layout, "x"))) * lanes_x_,
              y = int(field_value(word, field_named(layout, "y"))) * lanes_y_;
    const std::uint64_t pixels = std::uint64_t(std::min(lanes_x_, width_ - x)) * std::min(lanes_y_, height_ - y);
    out_.needed.index.read += pixels, out_.needed.index.written += pixels;
    out_.words.index.read += lanes_, out_.words.index.written += lanes_;
    if (has_objects_) out_.needed.depth.read += pixels, out_.words.depth.read += lanes_;
    seen_.clear();
    std::uint64_t covered = 0;
    for (int lane = 0; lane < lanes_; ++lane) {
      const std::int64_t entry = field_value(word, index, lane);
      covered += entry != 0;
      if (entry != 0 && std::find(seen_.begin(), seen_.end(), entry) == seen_.end()) seen_.push_back(entry);
    }
    out_.needed.shading.read += seen_.size(), out_.words.shading.read += by_pixel_ ? covered : seen_.size();
    if (has_objects_) out_.needed.object.read += seen_.size(), out_.words.object.read += seen_.size();
  }

  const bool by_pixel_, stores_depth_, tests_planes_, has_objects_;
  const std::string numbered_;  // the stream of triangles that have an index
  const int lanes_x_, lanes_, lanes_y_, width_, height_;
  std::vector<std::int64_t> seen_;
  Accesses out_;
};

}  // namespace

Accesses count_accesses(const Config& config, Engine& engine, const ref::SnappedList& scene) {
  Counter counter(config, engine, scene);
  engine.capture(
      scene, [&](const Layout& layout, const Word* words, std::size_t count) { counter.count(layout, words, count); });
  if (tests_planes(config)) {
    for (const PlaneTests& test : engine.plane_tests(scene)) counter.fetched(std::uint64_t(test.entries));
  }
  return counter.result();
}

}  // namespace halfspace::model
