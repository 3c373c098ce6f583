// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/units.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

namespace halfspace::tb {
namespace {

constexpr int kPause = 64;  // cycles after a frame in which a surplus word shows
// A pass that clears the whole buffer sends nothing for as many cycles as the largest frame has stamps.
constexpr std::uint64_t kClearPatience = 4'000'000;
constexpr const char* kSecondScan = " (second scan: the first one has to leave the I-buffer cleared)";
constexpr const char* kScanAfterClear = " (scan after a token with start_clear_i)";

struct Unit {
  const char* name;
  const char* ports;                  // what its ports' names begin with
  std::vector<const char*> sends;     // streams it takes
  std::vector<const char*> expects;   // streams and probes it sends
  std::vector<const char*> preloads;  // streams that the bench stores in the unit's buffer before the frame
  bool clears;                        // the bench clears the I-buffer before each frame
  bool follows = false;               // it has no register of a frame: words of the next one come at once
};

const Unit kUnits[] = {
    {"triangle_setup", "triangle_setup_", {"triangle"}, {"setup", "attributes"}, {}, false},
    {"visible_select", "visible_select_", {"attributes", "visible"}, {"visible", "visible_attributes"}, {}, false},
    {"shade_setup", "shade_setup_", {"attributes"}, {"planes"}, {}, false},
    {"raster_pineda", "raster_pineda_", {"setup"}, {"triangle_depth", "stamp"}, {}, false},
    {"ztest_index", "ztest_", {"stamp"}, {"update", "visible"}, {}, true},
    {"ztest_plane", "ztest_", {"triangle_depth", "stamp"}, {"update", "visible"}, {}, true},
    {"scan_index", "scan_index_", {}, {"scan"}, {"update"}, false},  // and a start token a frame: run_scan
    {"shade_gouraud", "shade_gouraud_", {"scan"}, {"pixel"}, {"planes"}, false},
    {"light_vertex", "light_vertex_", {"normals"}, {"colours"}, {"light", "material"}, false},
    {"phong_setup", "phong_setup_", {"visible_attributes", "normals"}, {"planes"}, {}, false},
    {"shade_phong", "shade_phong_", {"scan"}, {"pixel"}, {"light", "material", "planes"}, false},
    {"texture_setup", "texture_setup_", {"visible_attributes", "texture_coordinates"}, {"texture_planes"}, {}, false},
    {"shade_texture", "shade_texture_", {"scan", "lit"}, {"pixel"}, {"texture", "texel", "texture_planes"}, false},
    {"motion_setup", "motion_setup_", {"visible_attributes", "motion_vectors"}, {"motion_planes"}, {}, false},
    {"motion_field", "motion_field_", {"scan"}, {"motion"}, {"motion_planes"}, false},
    {"motion_compensate",
     "motion_compensate_",
     {"motion", "key_block_0", "key_block_1"},
     {"key_request_0", "key_request_1", "compensated"},
     {"key_weight"},
     false},
    {"ztest_merge", "ztest_merge_", {"merge", "stored", "entry"}, {"merged", "found"}, {}, false, true},
};

// The units of the configuration that a vector set is of: its streams tell which Z-test it has, and a stream that it
// has not is none of theirs.
std::vector<Unit> units_of(const Vectors& vectors) {
  const bool tests_planes = vectors.find("triangle_depth") != nullptr;
  std::vector<Unit> units;
  for (const Unit& unit : kUnits) {
    if (std::strcmp(unit.name, tests_planes ? "ztest_index" : "ztest_plane") == 0) continue;
    units.push_back(unit);
    if (std::strcmp(unit.name, "shade_setup") == 0 && vectors.find("colours"))
      units.back().sends = {"visible_attributes", "colours"};
    auto& expects = units.back().expects;
    if (!tests_planes)
      expects.erase(std::remove(expects.begin(), expects.end(), std::string("triangle_depth")), expects.end());
  }
  return units;
}

Unit find_unit(const std::string& name, const Vectors& vectors) {
  for (const Unit& unit : units_of(vectors)) {
    if (name == unit.name) return unit;
  }
  std::string names;
  for (const Unit& unit : units_of(vectors)) names += std::string(names.empty() ? "" : ", ") + unit.name;
  throw Error("--unit " + name + ": there is no such unit; take all or one of " + names);
}

const Stream& need_stream(const Vectors& vectors, const std::string& name) {
  if (const Stream* const stream = vectors.find(name)) return *stream;
  throw Error(vectors.directory + "/manifest.json: has no stream " + name +
              ", which the bench needs; make the set again");
}

Segment segment_of(const Stream& stream, std::size_t frame, const std::string& note = "") {
  std::size_t begin = 0;
  for (std::size_t f = 0; f < frame; ++f) begin += stream.frame_words[f];
  return {&stream, begin, begin + stream.frame_words[frame], frame, note};
}

// A unit on its bench, with the state that lasts from frame to frame.
class UnitBench {
 public:
  UnitBench(const Unit& unit, Model* model, const Vectors& vectors, const Options& options)
      : unit_(unit),
        vectors_(vectors),
        options_(options),
        bench_(model, &vectors, &options, unit.ports, std::string(unit.ports) + "clk_i") {
    for (const char* name : unit.preloads) preloads_.push_back(&bench_.add_sender(need_stream(vectors, name)));
    for (const char* name : unit.sends) senders_.push_back(&bench_.add_sender(need_stream(vectors, name)));
    for (const char* name : unit.expects) receivers_.push_back(&bench_.add_receiver(need_stream(vectors, name)));
  }

  Result run() {
    const Stopwatch stopwatch;
    bench_.reset();
    if (std::strcmp(unit_.name, "scan_index") == 0) {
      run_scan();
    } else if (unit_.follows) {
      for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) send_frame(frame);
      finish_frame();
    } else {
      for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
        if (!run_frame(frame)) break;
      }
    }
    Result result;
    result.unit = unit_.name;
    result.cycles = cycles_;
    result.cycles_of = "all frames, first to last word, stalls included";
    bench_.finish(&result);
    stopwatch.stop(&result);
    return result;
  }

 private:
  bool run_frame(std::size_t frame) {
    bench_.set_frame(vectors_.frames[frame]);
    if (unit_.clears) clear();
    if (!preload(frame)) return false;
    send_frame(frame);
    return finish_frame();
  }

  void send_frame(std::size_t frame) {
    for (std::size_t i = 0; i < senders_.size(); ++i) {
      senders_[i]->send(segment_of(need_stream(vectors_, unit_.sends[i]), frame));
    }
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      receivers_[i]->expect(segment_of(need_stream(vectors_, unit_.expects[i]), frame));
    }
  }

  // The scan itself, a second one that has to find the buffer cleared, and once a clear without a scan.
  void run_scan() {
    const Stream& scan = need_stream(vectors_, "scan");
    const Field& index = scan.need("index", "the bench of scan_index");
    cleared_ = scan;
    cleared_.words = Words(scan.bits);
    for (std::size_t n = 0; n < scan.words.size(); ++n) {
      std::uint32_t* const word = cleared_.words.append();
      std::memcpy(word, scan.words[n], scan.words.parts() * 4);
      const int end = index.lsb + index.width * index.count;
      for (int bit = index.lsb; bit < end; ++bit) word[bit / 32] &= ~(1u << (bit % 32));
    }
    tokens_.name = "start";
    tokens_.words = Words(1);
    tokens_.words.append();
    *tokens_.words.append() = 1;
    const auto port = [this](const char* name) { return &bench_.model().need(bench_.prefix() + name, 1); };
    const Wires wires{port("start_clear_i"), port("start_valid_i"), port("start_ready_o")};
    Sender& start = bench_.add_sender(wires, "start");

    clear();
    bool tried_clear = false;
    for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
      bench_.set_frame(vectors_.frames[frame]);
      if (!preload(frame)) return;
      start.send({&tokens_, 0, 1, frame, ""});
      receivers_[0]->expect(segment_of(scan, frame));
      if (!finish_frame()) return;
      start.send({&tokens_, 0, 1, frame, ""});
      receivers_[0]->expect(segment_of(cleared_, frame, kSecondScan));
      if (!finish_extra(options_.hang)) return;
      if (tried_clear || need_stream(vectors_, "update").frame_words[frame] == 0) continue;
      tried_clear = true;
      if (!preload(frame)) return;
      start.send({&tokens_, 1, 2, frame, ""});
      start.send({&tokens_, 0, 1, frame, ""});
      receivers_[0]->expect(segment_of(cleared_, frame, kScanAfterClear));
      if (!finish_extra(std::max(options_.hang, kClearPatience))) return;
    }
  }

  // All of the bench's I-buffer to 0, in one cycle.
  void clear() {
    const std::string port = bench_.prefix() + "clear_i";
    bench_.model().set(port, 1);
    bench_.idle(1);
    bench_.model().set(port, 0);
  }

  bool preload(std::size_t frame) {
    for (std::size_t i = 0; i < preloads_.size(); ++i) {
      preloads_[i]->send(segment_of(need_stream(vectors_, unit_.preloads[i]), frame));
    }
    const bool loaded = bench_.run([this] { return bench_.all_done(); }, options_.hang);
    bench_.idle(1);
    return loaded;
  }

  bool finish_frame() {
    const std::uint64_t before = bench_.cycle();
    const bool finished = bench_.run([this] { return bench_.all_done(); }, options_.hang);
    cycles_ += bench_.cycle() - before;
    bench_.idle(kPause);
    return finished;
  }

  // Passes that no frame asks for do not count as its cycles.
  bool finish_extra(std::uint64_t patience) {
    const bool finished = bench_.run([this] { return bench_.all_done(); }, patience);
    bench_.idle(kPause);
    return finished;
  }

  const Unit unit_;
  const Vectors& vectors_;
  const Options& options_;
  Bench bench_;
  std::vector<Sender*> senders_, preloads_;
  std::vector<Receiver*> receivers_;
  std::uint64_t cycles_ = 0;
  Stream cleared_, tokens_;  // of run_scan; the bench points to them until its end
};

}  // namespace

std::vector<std::string> unit_names(const Model& model, const Vectors& vectors) {
  std::vector<std::string> names;
  for (const Unit& unit : units_of(vectors)) {
    if (model.find(std::string(unit.ports) + "clk_i")) names.push_back(unit.name);
  }
  return names;
}

std::vector<std::string> unit_streams(const std::string& name, const Vectors& vectors) {
  const Unit unit = find_unit(name, vectors);
  std::vector<std::string> streams;
  for (const auto* list : {&unit.sends, &unit.expects, &unit.preloads}) {
    streams.insert(streams.end(), list->begin(), list->end());
  }
  return streams;
}

Result run_unit(const std::string& unit, Model* model, const Vectors& vectors, const Options& options) {
  return UnitBench(find_unit(unit, vectors), model, vectors, options).run();
}

}  // namespace halfspace::tb
