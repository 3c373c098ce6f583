// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/cycles.hpp"

#include <algorithm>

#include "hls/formats/formats.hpp"
#include "hls/formats/setup_interval.hpp"

namespace halfspace::model {
namespace {

using Cycle = std::int64_t;

// Words a queue holds (parameters of rtl/pipeline/hs_pipeline.sv); that of setups offers one more.
constexpr std::size_t kSetupQueue = 512 + 1, kAttributesQueue = 4, kScanQueue = 4;
constexpr Cycle kStampQueue = 4;

// Passes of a factor of `bits`, its sign not counted, through a multiplier that takes `chunk` of them (hs_plane_setup).
int passes(int bits, int chunk) { return (bits + chunk - 1) / chunk; }

// What hs_triangle_setup makes of a triangle.
struct SetupWork {
  bool outside;   // the box holds no pixel centre
  bool empty;     // or D = 0, or it is culled
  bool swapped;   // D < 0 as the vertices come
  int normalize;  // cycles to bring the leading one of D to the top
};

// Of the vertices as they come.
std::int64_t twice_area(const ref::SnappedTriangle& t) {
  return (std::int64_t(t.x[1]) - t.x[0]) * (std::int64_t(t.y[2]) - t.y[0]) -
         (std::int64_t(t.y[1]) - t.y[0]) * (std::int64_t(t.x[2]) - t.x[0]);
}

// Of a triangle with an area. The front has D < 0, as rows go downward.
bool is_culled(Cull which, std::int64_t area) { return which != Cull::kNone && (area < 0) == (which == Cull::kFront); }

// The box holds a pixel centre of 0 … size − 1.
bool holds_centre(const std::array<std::int32_t, 3>& at, int f, int size) {
  const auto [low, high] = std::minmax_element(at.begin(), at.end());
  const int half = 1 << (f - 1);
  return std::max((*low + half - 1) >> f, 0) <= std::min((*high - half) >> f, size - 1);
}

SetupCycles cycles_of(bool outside, bool empty, const UnitIntervals& intervals) {
  return {outside ? 3 : empty ? 7 : intervals.triangle_setup, empty ? 0 : intervals.shade_setup};
}

SetupWork setup_work(const Config& c, const ref::SnappedList& scene, const ref::SnappedTriangle& t) {
  SetupWork work{};
  work.outside = !holds_centre(t.x, c.subpixel_bits, scene.width) || !holds_centre(t.y, c.subpixel_bits, scene.height);
  std::int64_t area = twice_area(t);
  work.empty = work.outside || area == 0 || is_culled(c.cull, area);
  work.swapped = area < 0;
  if (work.swapped) area = -area;
  if (area == 0) return work;
  for (int zeros = 2 * (c.range_bits + c.subpixel_bits) - bits_for(area); zeros > 0; ++work.normalize) {
    zeros -= zeros >= 16 ? 16 : zeros >= 4 ? 4 : 1;
  }
  return work;
}

// The last `size` of the cycles at which a queue was left, of words numbered from 0; before the first word is long ago.
class Ring {
 public:
  explicit Ring(std::size_t size) : cycles_(size, -1) {}
  Cycle oldest() const { return cycles_[at_]; }
  void push(Cycle cycle) {
    cycles_[at_] = cycle;
    at_ = (at_ + 1) % cycles_.size();
  }

 private:
  std::vector<Cycle> cycles_;
  std::size_t at_ = 0;
};

class Pipeline {
 public:
  explicit Pipeline(const Config& c)
      : has_planes_(has_planes(c)),
        has_depth_(has_depth(c)),
        division_(c.reciprocal_bits + 3),
        depth_latency_(has_depth_ ? depth_plane_latency(c) : 0),
        shade_setup_(unit_intervals(c).shade_setup),
        setup_queue_(kSetupQueue),
        attributes_queue_(kAttributesQueue) {}

  // Its first triangle is let in at `open`; returns when it is drawn and its planes are stored.
  // `tests`: of the Z-test of each triangle; 0 if it is always as fast as the rasterizer.
  Cycle draw(Cycle open, const std::vector<SetupWork>& triangles, const std::vector<int>& visits,
             const std::vector<int>& tests) {
    edge_free_ = std::max(edge_free_, open);
    for (std::size_t k = 0; k < triangles.size(); ++k) {
      triangle(triangles[k], k + 1 == triangles.size(), std::max(visits[k], 1), tests[k]);
    }
    constexpr Cycle kToVisible = 8, kToPlanes = 9;
    return std::max(std::max(raster_free_, test_free_) + kToVisible, shade_free_ + kToPlanes);
  }

 private:
  // Cycles are those in which a word moves; names as in hs_edge_setup, hs_reciprocal, hs_triangle_setup.
  void triangle(const SetupWork& t, bool last, int visits, int tests) {
    Cycle edge_take, edge_valid, reciprocal_valid = 0;
    if (t.empty) {
      edge_take = std::max(edge_free_ + (t.outside ? 2 : 6), record_take_);
      edge_free_ = edge_take + 1;
      edge_valid = edge_take + 1;
    } else if (!has_planes_) {
      edge_take = std::max(edge_free_ + 6 + t.swapped, record_take_);
      edge_free_ = edge_take + 7;
      edge_valid = edge_take + 10;
    } else {
      const Cycle send = std::max(edge_free_ + 6 + t.swapped, divide_load_);
      edge_take = std::max(send + 1, record_take_);
      edge_free_ = edge_take + 7;
      edge_valid = edge_take + 10;
      divide_load_ = std::max(send + 1 + t.normalize, divide_free_);
      reciprocal_valid = divide_load_ + division_;
    }
    record_take_ = std::max({edge_valid, reciprocal_valid, record_free_});
    if (!t.empty) divide_free_ = record_take_;
    const Cycle setup_valid = record_take_ + 1 + (t.empty ? has_depth_ : depth_latency_);
    const Cycle setup_taken = std::max(setup_valid, setup_queue_.oldest());
    record_free_ = setup_taken;
    if (!t.empty || last) {
      const Cycle attributes_taken = std::max(record_take_ + 1, attributes_queue_.oldest() + 1);
      record_free_ = std::max(record_free_, attributes_taken);
      shade_free_ = std::max(attributes_taken, shade_free_) + (t.empty ? std::min(3, shade_setup_) : shade_setup_);
      attributes_queue_.push(shade_free_);
    }
    const Cycle raster_load = std::max(setup_taken + 2, raster_free_);
    setup_queue_.push(raster_load);
    raster_free_ = raster_load + visits;
    // Its last stamp is in the queue, or has found room there.
    test_free_ = std::max(raster_free_, std::max(raster_load, test_free_) + tests);
    if (tests != 0) raster_free_ = std::max(raster_free_, test_free_ - kStampQueue);
  }

  const bool has_planes_, has_depth_;
  const int division_, depth_latency_, shade_setup_;
  Ring setup_queue_, attributes_queue_;
  Cycle edge_free_ = 0, divide_load_ = 0, divide_free_ = 0, record_take_ = 0, record_free_ = 0;
  Cycle shade_free_ = 0, raster_free_ = 0, test_free_ = 0;
};

// Of the finished frame: its stamps, and for each stamp the different triangles in it, and its covered pixels, one for
// background alone.
struct ScanWork {
  std::uint64_t stamps = 0, groups = 0, pixels = 0;
};

ScanWork scan_work(const Engine& engine, const ref::Frame& frame) {
  ScanWork work;
  const int lanes_x = engine.lanes_x(), lanes_y = engine.lanes_y();
  std::vector<std::uint32_t> seen;
  for (int y = 0; y < frame.height; y += lanes_y) {
    for (int x = 0; x < frame.width; x += lanes_x) {
      seen.clear();
      std::uint64_t covered = 0;
      for (int j = y; j < std::min(y + lanes_y, frame.height); ++j) {
        for (int i = x; i < std::min(x + lanes_x, frame.width); ++i) {
          const std::uint32_t index = frame.index[std::size_t(j) * frame.width + i];
          covered += index != 0;
          if (index != 0 && std::find(seen.begin(), seen.end(), index) == seen.end()) seen.push_back(index);
        }
      }
      ++work.stamps;
      work.groups += std::max<std::size_t>(seen.size(), 1);
      work.pixels += std::max<std::uint64_t>(covered, 1);
    }
  }
  return work;
}

}  // namespace

UnitIntervals unit_intervals(const Config& c) {
  const FormatTable t = format_table(c);
  // A job takes six products by a distance and two by R, each in as many passes as the factor has chunks; a triangle
  // has three, which follow each other at once (hs_shade_setup). Flat colours go through.
  constexpr int kChunk = 24;
  const int colours = 3 * (6 * passes(t.delta.width - 1, kChunk) + 2 * passes(t.reciprocal.width, kChunk));
  return {setup_interval(c), shades_planes(c) ? colours : 1};
}

SetupModel::SetupModel(const Config& c, int width, int height)
    : subpixel_bits_(c.subpixel_bits), width_(width), height_(height), cull_(c.cull), intervals_(unit_intervals(c)) {}

bool SetupModel::has_sign(const ref::SnappedTriangle& t) const {
  return holds_centre(t.x, subpixel_bits_, width_) && holds_centre(t.y, subpixel_bits_, height_) && twice_area(t) != 0;
}

SetupCycles SetupModel::cycles(const ref::SnappedTriangle& t) const {
  const bool outside = !holds_centre(t.x, subpixel_bits_, width_) || !holds_centre(t.y, subpixel_bits_, height_);
  const std::int64_t area = twice_area(t);
  return cycles_of(outside, outside || area == 0 || is_culled(cull_, area), intervals_);
}

Cycles model_cycles(const Config& config, Engine& engine, const ref::SnappedList& scene, const ref::Frame& frame,
                    int frames) {
  const UnitIntervals intervals = unit_intervals(config);
  const ScanWork scan = scan_work(engine, frame);
  const std::vector<int> visits = engine.visits(scene);
  std::vector<SetupWork> triangles;
  Cycles result;
  for (const ref::SnappedTriangle& t : scene.triangles) {
    const SetupWork& work = triangles.emplace_back(setup_work(config, scene, t));
    const SetupCycles cycles = cycles_of(work.outside, work.empty, intervals);
    result.triangle_setup += std::uint64_t(cycles.triangle_setup);
    result.shade_setup += std::uint64_t(cycles.shade_setup);
  }
  for (const int count : visits) result.raster += std::max(count, 1);
  std::vector<int> tests(scene.triangles.size());
  if (tests_planes(config)) {
    const std::vector<PlaneTests> costs = engine.plane_tests(scene);
    for (std::size_t k = 0; k < tests.size(); ++k) tests[k] = costs[k].cycles;
    for (const int count : tests) result.test += std::uint64_t(count);
  }
  result.scan_out = is_phong(config) ? scan.pixels * std::uint64_t(config.lights) : scan.groups;
  if (has_texture(config)) result.scan_out = std::max(result.scan_out, scan.pixels);

  Pipeline pipeline(config);
  std::vector<Cycle> pixel_done;
  Cycle scan_free = 0, shade_free = 0;
  for (int n = 0; n < frames; ++n) {
    const Cycle open = n < 2 ? 0 : pixel_done[n - 2] + 1;
    const Cycle start = std::max(pipeline.draw(open, triangles, visits, tests), scan_free);
    shade_free = std::max(start + 2, shade_free) + Cycle(result.scan_out);
    scan_free = std::max(start + 2 + Cycle(scan.stamps), shade_free - Cycle(kScanQueue));
    constexpr Cycle kToPixel = 9;
    pixel_done.push_back(shade_free + kToPixel);
  }
  result.frame = std::uint64_t(frames == 1 ? pixel_done[0] : pixel_done[frames - 1] - pixel_done[frames - 2]);
  return result;
}

}  // namespace halfspace::model
