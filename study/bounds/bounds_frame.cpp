// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "model/pipeline/engine.hpp"
#include "study/bounds/bounds_measure.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::model {
namespace {

// The words of a stream with their fields by name.
class Stream {
 public:
  Stream() = default;
  Stream(const Layout& layout, const Word* words, std::size_t count) : layout_(layout), words_(words, words + count) {}

  std::size_t size() const { return words_.size(); }
  bool has(const char* name) const {
    for (const Field& field : layout_.fields) {
      if (field.name == name) return true;
    }
    return false;
  }
  std::uint32_t get(std::size_t n, const char* name, int lane = 0) const {
    for (const Field& field : layout_.fields) {
      if (field.name != name) continue;
      const int at = field.lsb + lane * field.width;
      std::uint64_t bits = words_[n][at / 64] >> (at % 64);
      if (at % 64 + field.width > 64) bits |= words_[n][at / 64 + 1] << (64 - at % 64);
      return std::uint32_t(bits & ((std::uint64_t(1) << field.width) - 1));
    }
    return 0;
  }

 private:
  Layout layout_;
  std::vector<Word> words_;
};

struct Kept {
  std::uint32_t index = 0, depth = 0;
};

// The fragments of one frame in the order they were sent, tested one by one; then the indices that are scanned out.
// Triangle k is of objects[k]; without objects there are none.
void replay(Engine& engine, const NamedFrame& frame, const std::vector<std::uint32_t>& objects, std::uint64_t number,
            BoundsReport& report) {
  std::map<std::string, Stream> streams;
  engine.capture(frame.scene, [&](const Layout& layout, const Word* words, std::size_t count) {
    streams[layout.stream] = Stream(layout, words, count);
  });
  const Stream &stamp = streams["stamp"], &update = streams["update"], &scan = streams["scan"];
  const int lanes_x = engine.lanes_x(), lanes = lanes_x * engine.lanes_y();
  const int width = frame.scene.width, height = frame.scene.height;
  const bool has_depth = frame.scene.format.depth_bits != 0;
  const std::uint32_t farthest = has_depth ? ref::full_depth(frame.scene.format.depth_bits) : 0;
  std::vector<Kept> kept(std::size_t(width) * height);
  auto see = [&](Quantity q, bool equal, int x, int y) {
    if (report.rows[q].count(1, !equal)) report.rows[q].where = {frame.note, number, false, {}, x, y};
  };
  auto pixel = [&](const Stream& stream, std::size_t n, int lane) {
    return std::pair(int(stream.get(n, "x")) * lanes_x + lane % lanes_x,
                     int(stream.get(n, "y")) * engine.lanes_y() + lane / lanes_x);
  };

  std::size_t next = 0;  // update that is due
  for (std::size_t n = 0; n < stamp.size(); ++n) {
    const std::uint32_t index = stamp.get(n, "index");
    std::vector<bool> pass(lanes, false);
    bool any = false;
    for (int l = 0; l < lanes; ++l) {
      if (!stamp.get(n, "mask", l)) continue;
      const auto [x, y] = pixel(stamp, n, l);
      Kept& at = kept[std::size_t(y) * width + x];
      const std::uint32_t depth = stamp.get(n, "depth", l);
      pass[l] = has_depth ? depth < (at.index ? at.depth : farthest) : at.index == 0;
      if (pass[l]) at = {index, depth};
      any = any || pass[l];
    }
    const bool due = any && next < update.size() && update.get(next, "index") == index &&
                     pixel(update, next, 0) == pixel(stamp, n, 0);
    for (int l = 0; l < lanes; ++l) {
      if (!stamp.get(n, "mask", l)) continue;
      const auto [x, y] = pixel(stamp, n, l);
      const bool sent = due && update.get(next, "mask", l) != 0;
      // Type γ keeps an index alone.
      const bool kept_depth = !sent || !update.has("depth") || update.get(next, "depth", l) == stamp.get(n, "depth", l);
      see(kZtest, sent == pass[l] && kept_depth, x, y);
    }
    next += any;
  }
  if (next != update.size()) see(kZtest, false, -1, -1);

  std::size_t pixels = 0;
  for (std::size_t n = 0; n < scan.size(); ++n) {
    for (int l = 0; l < lanes; ++l) {
      const auto [x, y] = pixel(scan, n, l);
      if (x >= width || y >= height) continue;
      ++pixels;
      see(kScan, scan.get(n, "index", l) == kept[std::size_t(y) * width + x].index, x, y);
    }
  }
  if (pixels != kept.size()) see(kScan, false, -1, -1);
  if (objects.empty()) return;
  // An index that is given again is of the last triangle that has it: those before it were invisible.
  std::map<std::uint32_t, std::uint32_t> object_of;
  const Stream& numbered = streams["numbered"];
  for (std::size_t k = 0; k < objects.size(); ++k)
    object_of[numbered.size() != 0 ? numbered.get(k, "index") : std::uint32_t(k + 1)] = objects[k];
  const Stream& entry = streams["entry"];
  const std::uint32_t background = ref::full_depth(frame.scene.format.depth_bits);
  for (std::size_t n = 0; n < entry.size(); ++n) {
    for (int l = 0; l < lanes; ++l) {
      const auto [x, y] = pixel(entry, n, l);
      if (x >= width || y >= height) continue;
      const Kept& at = kept[std::size_t(y) * width + x];
      const std::uint32_t object = at.index ? object_of[at.index] : 0, depth = at.index ? at.depth : background;
      see(kEntry, entry.get(n, "object", l) == object && entry.get(n, "depth", l) == depth, x, y);
    }
  }
}

// Each of one depth, of a few, so that most fragments are as far as what is stored.
void flatten(std::vector<ref::SnappedTriangle>& triangles, const Config& config) {
  if (!has_depth(config)) return;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    triangles[k].depth.fill(ref::full_depth(config.depth_bits) - std::uint32_t(k * 7 % 3));
  }
}

}  // namespace

void measure_frames(const Configuration& configuration, std::uint64_t seed, BoundsReport& report) {
  const auto engine = make_engine(configuration, configuration.config().lanes);
  std::uint64_t number = 0;
  const Config config = configuration.config();
  // Full frames, and ones in which the background is seen.
  std::vector<NamedFrame> frames = random_frames(raster_format(configuration), seed, 4, 100);
  for (NamedFrame& frame : random_frames(raster_format(configuration), seed + 1, 4, 4))
    frames.push_back(std::move(frame));
  for (NamedFrame& frame : frames) {
    const std::size_t triangles = frame.scene.triangles.size();
    if (number % 2 == 1) flatten(frame.scene.triangles, config);
    if (has_lighting(config)) frame.lighting = awkward_normals(triangles, config, seed);
    if (has_texture(config)) frame.texture = awkward_coordinates(triangles, config, seed);
    if (has_motion(config)) frame.motion = awkward_motion(frame.scene, config, seed);
    std::vector<std::uint32_t>& objects = frame.objects;
    const std::uint32_t bits = std::uint32_t(configuration.config().object_bits), most = (1u << bits) - 1;
    for (std::uint32_t k = 0; bits != 0 && k < frame.scene.triangles.size(); ++k)
      objects.push_back(1 + (k * 7 + number) % most);
    load_frame(*engine, config, frame);
    replay(*engine, frame, objects, ++number, report);
  }
}

}  // namespace halfspace::model
