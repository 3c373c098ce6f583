// SPDX-License-Identifier: Apache-2.0
#include "tb/report/accesses.hpp"

#include <algorithm>

namespace halfspace::tb {
namespace {

constexpr const char* kPurpose = "the accesses of the buffers";

// The words of a stream of the last frame.
struct Received {
  const Stream& stream;
  const Words& words;

  std::size_t size() const { return words.size(); }
  const Field& field(const char* name) const { return stream.need(name, kPurpose); }
  std::uint64_t raw(std::size_t n, const char* name) const { return field(name).raw(words[n]); }
  // Words, or lanes, in which the field is not 0.
  std::uint64_t set(const char* name) const {
    const Field& of = field(name);
    std::uint64_t count = 0;
    for (std::size_t n = 0; n < words.size(); ++n) {
      for (int lane = 0; lane < of.count; ++lane) count += of.raw(words[n], lane) != 0;
    }
    return count;
  }
};

// The different entries in some lanes of a stamp, 0 not among them.
class Different {
 public:
  void add(std::uint64_t entry) {
    if (entry != 0 && std::find(seen_.begin(), seen_.end(), entry) == seen_.end()) seen_.push_back(entry);
  }
  std::uint64_t take() {
    const std::uint64_t count = seen_.size();
    seen_.clear();
    return count;
  }

 private:
  std::vector<std::uint64_t> seen_;
};

// Type γ fetches the planes of the triangles that are stored under the fragments of a stamp: the I-buffer is drawn
// again, stamp by stamp. The update of a stamp, if there is one, is the next of the same triangle and place; an
// invisible triangle has none.
std::uint64_t fetched_planes(const Vectors& vectors, const Received& stamp, const Received& update,
                             const Received& visible) {
  const Frame& frame = vectors.frames.back();
  const std::size_t stamps_x = (frame.width + vectors.lanes_x - 1) / vectors.lanes_x;
  const std::size_t stamps_y = (frame.height + vectors.lanes_y - 1) / vectors.lanes_y;
  const int lanes = vectors.lanes();
  std::vector<std::uint64_t> index(stamps_x * stamps_y * lanes);
  const Field &mask = stamp.field("mask"), &passed = update.field("mask");
  std::uint64_t fetched = 0;
  std::size_t triangle = 0, next = 0;
  Different different;
  for (std::size_t n = 0; n < stamp.size(); ++n) {
    const std::uint64_t x = stamp.raw(n, "x"), y = stamp.raw(n, "y");
    std::uint64_t* const stored = x < stamps_x && y < stamps_y ? &index[(y * stamps_x + x) * lanes] : nullptr;
    for (int lane = 0; stored && lane < lanes; ++lane) {
      if (mask.raw(stamp.words[n], lane)) different.add(stored[lane]);
    }
    fetched += different.take();
    if (stored && triangle < visible.size() && visible.raw(triangle, "visible") && next < update.size() &&
        update.raw(next, "x") == x && update.raw(next, "y") == y &&
        update.raw(next, "index") == stamp.raw(n, "index")) {
      for (int lane = 0; lane < lanes; ++lane) {
        if (passed.raw(update.words[next], lane)) stored[lane] = update.raw(next, "index");
      }
      ++next;
    }
    triangle += stamp.raw(n, "triangle_last");
  }
  return fetched;
}

// Bits of a word but for the fields that say where it goes.
std::uint64_t content_bits(const Stream& stream, std::initializer_list<const char*> address) {
  std::uint64_t bits = std::uint64_t(stream.bits);
  for (const char* name : address) bits -= stream.need(name, kPurpose).width;
  return bits;
}

}  // namespace

std::vector<Accesses> count_accesses(const Vectors& vectors, const std::map<std::string, Words>& received,
                                     const Largest& largest) {
  const bool moves = vectors.find("motion_planes") != nullptr;
  const char* const planes_name = moves ? "motion_planes" : "planes";
  for (const char* name : {"stamp", "update", "visible", "scan", planes_name}) {
    if (vectors.find(name) == nullptr) return {};  // a set of one's own may lack it
  }
  const auto all = [&](const char* name) {
    static const Words kNone(1);
    const auto words = received.find(name);
    return Received{*vectors.find(name), words == received.end() ? kNone : words->second};
  };
  const Received stamp = all("stamp"), update = all("update"), visible = all("visible"), scan = all("scan");
  const Received planes = all(planes_name);
  const std::uint64_t lanes = vectors.lanes(), fragments = stamp.set("mask"), passed = update.set("mask");
  const auto whole = [](std::uint64_t size, int stamp_size) {
    return (size + stamp_size - 1) / stamp_size * stamp_size;
  };
  const std::uint64_t pixels = whole(largest.width, vectors.lanes_x) * whole(largest.height, vectors.lanes_y);
  std::uint64_t triangles = 1;
  while (triangles < largest.triangles) triangles *= 2;
  std::vector<Accesses> result;
  const Stream* const triangle = vectors.find("triangle");
  const Field* const numbered = triangle ? triangle->find("object") : nullptr;
  const Frame& frame = vectors.frames.back();

  const auto add = [&](Accesses a, std::uint64_t entries) {
    a.memory_bits = entries * a.entry_bits;
    result.push_back(a);
  };
  if (const Field* const depth = update.stream.find("depth")) {
    // Where pixels know their objects the scan-out reads it as well, from a second bank.
    const std::uint64_t scanned = numbered ? frame.width * frame.height : 0, read = numbered ? scan.size() * lanes : 0;
    add({"depth_buffer", std::uint64_t(depth->width), fragments + scanned, passed, stamp.size() * lanes + read, passed},
        (numbered ? 2 : 1) * pixels);
  }

  const Field& index = scan.field("index");
  std::uint64_t shown = 0, entries = 0, covered = 0;
  Different different;
  for (std::size_t n = 0; n < scan.size(); ++n) {
    for (int lane = 0; lane < int(lanes); ++lane) {
      const std::uint64_t x = scan.raw(n, "x") * vectors.lanes_x + lane % vectors.lanes_x;
      const std::uint64_t y = scan.raw(n, "y") * vectors.lanes_y + lane / vectors.lanes_x;
      shown += x < frame.width && y < frame.height;
      different.add(index.raw(scan.words[n], lane));
      covered += index.raw(scan.words[n], lane) != 0;
    }
    entries += different.take();
  }
  add({"index_buffer", std::uint64_t(index.width), fragments + shown, passed + shown,
       (stamp.size() + scan.size()) * lanes, passed + scan.size() * lanes},
      2 * pixels);

  if (const Stream* const depths = vectors.find("triangle_depth")) {
    const std::uint64_t fetched = fetched_planes(vectors, stamp, update, visible), stored = visible.set("visible");
    add({"visibility_database", content_bits(*depths, {"index", "x", "y"}), fetched, stored, fetched, stored},
        triangles);
  }
  const std::uint64_t stored = planes.size() - planes.set("empty");
  add({"shading_database", content_bits(planes.stream, {"last", "empty", "index"}), entries, stored,
       moves || planes.stream.find("material") ? covered : entries, stored},
      2 * triangles);  // shade_phong and motion_field read it for each pixel
  if (numbered) {
    const std::uint64_t came = visible.set("index");  // 0: a frame without triangles
    add({"object_table", std::uint64_t(numbered->width), entries, came, entries, came}, 2 * triangles);
  }
  return result;
}

}  // namespace halfspace::tb
