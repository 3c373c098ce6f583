// SPDX-License-Identifier: Apache-2.0
#include "tb/report/unit_work.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "tb/harness/channel.hpp"
#include "tb/harness/plan.hpp"
#include "tb/report/setup_work.hpp"

namespace halfspace::tb {
namespace {

constexpr const char* kPurpose = "the interval of a unit";
constexpr std::uint64_t kTile = 8;  // pixels, each way

std::uint64_t ceil_of(std::uint64_t number, std::uint64_t by) { return (number + by - 1) / by; }

// A frame of the set, for a model of the unit.
struct Job {
  const Model& model;
  const Vectors& vectors;
  std::size_t frame;
  std::uint64_t cycle;

  std::uint64_t constant(const char* name) const { return std::uint64_t(model.constant(name)); }
  std::uint64_t words(const char* stream) const { return need_stream(vectors, stream).frame_words[frame]; }
  // The sum over the words of a stream.
  std::uint64_t sum(const char* name,
                    const std::function<std::uint64_t(const Stream&, const std::uint32_t*)>& of) const {
    const Stream& stream = need_stream(vectors, name);
    const Segment words = segment_of(stream, frame);
    std::uint64_t total = 0;
    for (std::size_t n = words.begin; n < words.end; ++n) total += of(stream, stream.words[n]);
    return total;
  }
  // That have a word, which follow each other.
  std::uint64_t tiles(const char* name) const {
    std::uint64_t before = ~std::uint64_t(0);
    return sum(name, [&](const Stream& stream, const std::uint32_t* word) {
      const auto tile = [&](const char* place) { return stream.need(place, kPurpose).raw(word) / kTile; };
      const std::uint64_t at = tile("y") << 32 | tile("x");
      return std::uint64_t(std::exchange(before, at) != at);
    });
  }
  const char* scan() const { return vectors.find("masked") && !model.find("masked_valid_o") ? "masked" : "scan"; }
  // One for a stamp of background.
  std::uint64_t covered_lanes() const {
    return sum(scan(), [](const Stream& stream, const std::uint32_t* word) {
      const Field& index = stream.need("index", kPurpose);
      std::uint64_t covered = 0;
      for (int lane = 0; lane < index.count; ++lane) covered += index.raw(word, lane) != 0;
      return std::max<std::uint64_t>(covered, 1);
    });
  }
  std::uint64_t different_triangles() const {
    return sum(scan(), [](const Stream& stream, const std::uint32_t* word) {
      const Field& index = stream.need("index", kPurpose);
      std::uint64_t different = 0;
      for (int lane = 0; lane < index.count; ++lane) {
        bool is_new = index.raw(word, lane) != 0;
        for (int other = 0; other < lane; ++other) is_new = is_new && index.raw(word, other) != index.raw(word, lane);
        different += is_new;
      }
      return std::max<std::uint64_t>(different, 1);
    });
  }
  // A stamp a cycle of the box of a command, or of the whole frame where that takes a pass; and 4 a command.
  std::uint64_t runs() const {
    const Frame& size = vectors.frames[frame];
    const std::uint64_t whole =
        ceil_of(size.width, std::uint64_t(vectors.lanes_x)) * ceil_of(size.height, std::uint64_t(vectors.lanes_y));
    return sum("command", [&](const Stream& stream, const std::uint32_t* word) {
      const auto raw = [&](const char* name) { return stream.need(name, kPurpose).raw(word); };
      const std::uint64_t columns = raw("x_last") - raw("x_first") + 1, rows = raw("y_last") - raw("y_first") + 1;
      return 4 + (raw("passes") ? whole : columns * rows);
    });
  }
  // Three planes of a triangle, or two of them, one after the other through hs_channel_planes: six products by a
  // distance and two by the reciprocal, each in as many passes as a factor has chunks. An empty one takes 3.
  std::uint64_t planes(std::uint64_t channels) const {
    constexpr std::uint64_t kChunk = 24;
    const std::uint64_t a_plane =
        6 * ceil_of(constant("DeltaBits") - 1, kChunk) + 2 * ceil_of(constant("ReciprocalBits"), kChunk);
    const char* const name = vectors.find("visible_attributes") && !model.find("visible_attributes_valid_o")
                                 ? "visible_attributes"
                                 : "attributes";
    return sum(name, [&](const Stream& stream, const std::uint32_t* word) {
      return stream.need("empty", kPurpose).raw(word) ? 3 : channels * a_plane;
    });
  }
};

// Of type γ: a slot for each different triangle that is stored in the covered lanes of a stamp, one if there is none,
// and one for a triangle; a stamp that has a pixel in common with one in flight goes on when that is written.
std::uint64_t plane_tests(const Job& job) {
  constexpr std::uint64_t kToWrite = 11;
  const Stream &stamps = need_stream(job.vectors, "stamp"), &updates = need_stream(job.vectors, "update");
  const auto field = [](const Stream& stream, const char* name) { return stream.need(name, kPurpose); };
  const Field x = field(stamps, "x"), y = field(stamps, "y"), index = field(stamps, "index");
  const Field mask = field(stamps, "mask"), ends = field(stamps, "triangle_last");
  const Field update_x = field(updates, "x"), update_y = field(updates, "y"), update_index = field(updates, "index");
  const Field passed = field(updates, "mask");
  struct Lane {
    std::uint64_t triangle = 0, written = 0;  // what is stored, and the cycle of the last write
  };
  std::map<std::uint64_t, std::vector<Lane>> buffer;
  const Segment words = segment_of(stamps, job.frame), writes = segment_of(updates, job.frame);
  std::uint64_t cycle = 0;
  std::size_t next = writes.begin;
  bool begins = true;
  for (std::size_t n = words.begin; n < words.end; ++n) {
    const std::uint32_t* const word = stamps.words[n];
    std::vector<Lane>& lanes = buffer[x.raw(word) | y.raw(word) << 32];
    lanes.resize(std::size_t(mask.count));
    std::vector<std::uint64_t> seen;
    std::uint64_t free = cycle;
    for (int l = 0; l < mask.count; ++l) {
      if (!mask.raw(word, l)) continue;
      const Lane& lane = lanes[std::size_t(l)];
      free = std::max(free, lane.written);
      if (lane.triangle != 0 && std::find(seen.begin(), seen.end(), lane.triangle) == seen.end())
        seen.push_back(lane.triangle);
    }
    cycle = free + std::max<std::uint64_t>(seen.size(), 1) + begins;
    begins = ends.raw(word) != 0;
    for (int l = 0; l < mask.count; ++l) {
      if (mask.raw(word, l)) lanes[std::size_t(l)].written = cycle + kToWrite;
    }
    const std::uint32_t* const write = next < writes.end ? updates.words[next] : nullptr;
    if (!write || update_x.raw(write) != x.raw(word) || update_y.raw(write) != y.raw(word) ||
        update_index.raw(write) != index.raw(word))
      continue;
    ++next;
    for (int l = 0; l < mask.count; ++l) {
      if (passed.raw(write, l)) lanes[std::size_t(l)].triangle = index.raw(word);
    }
  }
  return cycle;
}

// Of triangle_setup: an empty triangle waits in the output of the edges until the one before it has been divided, a
// second one until its depth plane has left, and keeps the next one from being looked at meanwhile. So that one takes
// the cycles until D is known besides, and those that bring the leading one of D to the top, by 16, 4 or 1 places.
std::uint64_t behind_empty(const Job& job) {
  const std::uint64_t until_division = 8 + job.constant("AreaBits") / 16 + 6;
  const std::uint64_t depth = job.constant("HasDepth") ? job.constant("SetupInterval") : 0;
  int empty = 0;
  return job.sum("setup", [&](const Stream& stream, const std::uint32_t* word) -> std::uint64_t {
    const int before = empty;
    empty = stream.need("empty", kPurpose).raw(word) ? empty + 1 : 0;
    return empty != 0 || before == 0 ? 0 : until_division + (before > 1 ? depth : 0);
  });
}

// Of hs_plane_setup: where the next triangle is not there, the start of the plane before is issued first, three cycles
// behind its gradient.
constexpr std::uint64_t kRestart = 4;

UnitWork work_of(const std::string& unit, const Job& job) {
  const auto known = [](std::uint64_t intervals, std::uint64_t latency, std::uint64_t restart = 0) {
    return UnitWork{intervals, latency, restart, true};
  };
  const Frame& frame = job.vectors.frames[job.frame];
  const bool perspective = job.constant("Perspective") != 0;
  const std::uint64_t lights = job.constant("Lights");
  const std::uint64_t to_light = 12 + 2 * job.constant("Squarings");
  if (unit == "index_pool") return known(job.words("triangle"), 2);
  if (unit == "triangle_setup") {
    const Stream& setup = need_stream(job.vectors, "setup");
    const std::size_t from = segment_of(setup, job.frame).begin;
    // Where the edges decide, a triangle with D < 0 takes a cycle more.
    const std::uint64_t edges = 15;
    const std::uint64_t interval = job.constant("SetupInterval") + (job.constant("SetupInterval") < edges ? 1 : 0);
    const std::uint64_t cycles = setup_work(job.vectors, setup.words, from, job.frame, interval).cycles;
    return known(cycles + behind_empty(job), interval + 12);
  }
  if (unit == "raster_pineda" && frame.visits >= 0) return known(std::uint64_t(frame.visits), 4);
  if (unit == "ztest_index") return known(job.words("stamp"), 4);
  if (unit == "ztest_plane") return known(plane_tests(job), 12);
  if (unit == "visible_select") return known(job.words("attributes"), 1);
  if (unit == "shade_setup" && !job.constant("Gouraud")) return known(job.words("planes"), 1);
  if (unit == "shade_setup" || unit == "phong_setup") return known(job.planes(3), 10, kRestart);
  if (unit == "texture_setup") return known(job.planes(perspective ? 3 : 2), 10, kRestart);
  if (unit == "motion_setup") {
    // Of groups of two and of three channels the shorter one waits with its planes for the other's, and begins late.
    const bool unequal = !perspective && job.constant("Relight") != 0;
    const std::uint64_t late = unequal ? kRestart * job.words("motion_planes") : 0;
    return known(job.planes(perspective || unequal ? 3 : 2) + late, 10, kRestart);
  }
  if (unit == "scan_index") return known(job.words("scan"), 2);
  if (unit == "shade_gouraud") return known(job.different_triangles(), 9);
  if (unit == "scan_object") return known(job.different_triangles(), 4);
  if (unit == "light_vertex") {
    const bool flat = need_stream(job.vectors, "colours").find("r1") == nullptr;
    return known(job.words("normals") * (flat ? 1 : 3) * lights, to_light + lights);
  }
  if (unit == "shade_phong") return known(job.covered_lanes() * lights, 8 + to_light + lights);
  if (unit == "shade_texture")
    return known(job.covered_lanes(), 17 + (job.constant("Bilinear") ? 7 : 0) + (perspective ? 3 : 0));
  if (unit == "motion_field") return known(job.covered_lanes(), perspective ? 17 : 12);
  if (unit == "pixel_store") return known(job.words("shown"), 3);
  if (unit == "motion_order") {
    const std::uint64_t tiles = ceil_of(frame.width, kTile) * ceil_of(frame.height, kTile);
    const std::uint64_t empty = tiles - std::min(tiles, job.tiles("ordered"));
    const std::uint64_t clear = ceil_of(job.constant("MaxWidth"), kTile) * ceil_of(job.constant("MaxHeight"), kTile);
    return known(job.words("motion") + job.words("ordered") + empty, 6 + clear - std::min(clear, job.cycle));
  }
  if (unit == "hole_find") return known(job.words("compensated") + 1, 2);
  if (unit == "hole_scan") return known(job.words("scan"), 1);
  if (unit == "film_scan")
    return known(job.words("film"), 2 * job.sum("film", [](const Stream& stream, const std::uint32_t* word) {
      return stream.need("last", kPurpose).raw(word);
    }));
  if (unit == "ztest_merge" && frame.cycles >= 0) return known(std::uint64_t(frame.cycles), 3);
  if (unit == "motion_compensate" && frame.cycles >= 0) return known(std::uint64_t(frame.cycles), 0);
  if (unit == "motion_compensate") {
    const std::uint64_t blocks = kTile / job.constant("KeySide") * (kTile / job.constant("KeySide"));
    const std::uint64_t tiles = job.words("key_request_0") + job.words("key_request_1");
    return known(job.words("compensated") + tiles * (1 + blocks), 15);
  }
  if (unit == "static_run") return known(job.runs(), 4);
  return {};
}

}  // namespace

UnitWork unit_work(const Model& model, const Vectors& vectors, std::size_t frame, std::uint64_t cycle) {
  return work_of(unit_of(model), {model, vectors, frame, cycle});
}

void DueWork::add(std::size_t frame, const UnitWork& work, bool follows, const Waits& now) {
  if (frames_++ == 0) {
    first_ = frame;
    from_ = now;
    work_ = UnitWork{0, 0, 0, true};
  }
  work_.intervals += work.intervals;
  work_.latency = follows ? work.latency : work_.latency + work.latency;
  work_.restart = work.restart;
  work_.known = work_.known && work.known;
}

std::string DueWork::slow(const Waits& now) {
  const std::size_t frames = std::exchange(frames_, 0);
  const std::uint64_t cycles = now.cycle - from_.cycle;
  const std::uint64_t stalled = now.stalled - from_.stalled + work_.restart * (now.late - from_.late);
  const std::uint64_t most = work_.intervals + work_.latency + stalled;
  if (frames == 0 || !work_.known || cycles <= most) return "";
  const std::string behind = frames == 1 ? "" : " and the " + std::to_string(frames - 1) + " sent behind it";
  return "slow: frame " + std::to_string(first_) + behind + " took " + std::to_string(cycles) + " cycles, and " +
         std::to_string(most) + " is the most: " + std::to_string(work_.intervals) +
         " by the intervals of the words, " + std::to_string(work_.latency) + " of latency, " +
         std::to_string(stalled) + " in which the bench made it wait";
}

}  // namespace halfspace::tb
