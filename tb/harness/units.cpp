// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/units.hpp"

#include <algorithm>
#include <cstring>
#include <set>

namespace halfspace::tb {
namespace {

constexpr int kPause = 64;  // cycles after a frame in which a surplus word shows
// A pass that clears the whole buffer sends nothing for as many cycles as the largest frame has stamps.
constexpr std::uint64_t kClearPatience = 4'000'000;
constexpr const char* kSecondScan = " (second scan: the first one has to leave the I-buffer cleared)";
constexpr const char* kScanAfterClear = " (scan after a token with start_clear_i)";

// The memories of the units. TdbV and TdbS: a word a triangle.
const MemoryPorts kIndexBuffer{"read_index_i", "read_en_o",    "read_bank_o",     "read_address_o",
                               "write_en_o",   "write_bank_o", "write_address_o", "write_index_o"};
const MemoryPorts kScannedIndexBuffer{"read_index_i", "read_en_o", nullptr,     "address_o",
                                      "write_en_o",   nullptr,     "address_o", nullptr};
const MemoryPorts kDepthBuffer{"read_depth_i", "read_en_o", nullptr,           "read_address_o",
                               "write_en_o",   nullptr,     "write_address_o", "write_depth_o"};
const MemoryPorts kVisibilityDatabase{"fetch_plane_i", "fetch_en_o", nullptr,         "fetch_entry_o",
                                      "store_en_o",    nullptr,      "store_entry_o", "store_plane_o"};
const MemoryPorts kShadingDatabase{"read_planes_i", "read_en_o", "read_bank_o", "read_entry_o",
                                   nullptr,         nullptr,     nullptr,       nullptr};
// Whose words are in a memory that the unit only reads, or that it finds full: no port tells.
struct Filled {
  const char *unit, *stream;
};
const Filled kFilled[] = {{"scan_index", "update"},
                          {"shade_gouraud", "planes"},
                          {"shade_phong", "planes"},
                          {"shade_texture", "texture_planes"},
                          {"motion_field", "motion_planes"}};

std::string unit_of(const Model& model) { return model.top().substr(std::strlen("hs_")); }

const Stream& need_stream(const Vectors& vectors, const std::string& name) {
  if (const Stream* const stream = vectors.find(name)) return *stream;
  throw Error(vectors.directory + "/manifest.json: has no stream " + name +
              ", which the bench needs; make the set again");
}

// Where a stage stands between two units, its stream goes into the port that the other one's goes into where there is
// none: `attributes` behind visible_select, `pixel` before shade_texture.
std::string port_of(const Model& model, const Vectors& vectors, const std::string& stream, const char* between,
                    const char* without) {
  if (!vectors.find(between) || model.find(std::string(between) + "_valid_o")) return stream;
  return stream == between ? without : stream == without ? "" : stream;
}

// Streams that leave or enter the unit, but that its configuration does not have; and what is no stream of data.
bool is_idle(const Model& model, const std::string& stream) {
  if (stream == "triangle_depth") return !model.constant("HasDepth") || model.constant("StoresDepth");
  if (stream == "colours") return !model.constant("Lights");
  return stream == "start";
}

// What is done with the ports of a unit: all that its bench has to know of it.
struct Plan {
  struct End {
    const Stream* stream;
    std::string port;
  };
  std::vector<End> takes, sends;
  std::vector<End> loads;      // what it takes in any cycle, so that nothing else may be in flight: before a frame
  std::vector<End> registers;  // a word before a frame, which stays
  const Stream* fills = nullptr;

  std::vector<const Stream*> streams() const {
    std::vector<const Stream*> all;
    for (const auto* const list : {&takes, &sends, &loads, &registers}) {
      for (const End& end : *list) all.push_back(end.stream);
    }
    if (fills) all.push_back(fills);
    return all;
  }
};

Plan plan_of(const Model& model, const Vectors& vectors) {
  Plan plan;
  std::set<std::string> used;
  for (const Stream& stream : vectors.streams) {
    const std::string in = port_of(model, vectors, stream.name, "visible_attributes", "attributes");
    if (model.find(in + "_valid_i")) {
      (model.find(in + "_ready_o") ? plan.takes : plan.loads).push_back({&stream, in});
      used.insert(in + "_valid_i");
    } else if (model.find(in + "_i")) {
      plan.registers.push_back({&stream, in});
    }
    const std::string out =
        model.find("lit_valid_i") ? stream.name : port_of(model, vectors, stream.name, "lit", "pixel");
    if (model.find(out + "_valid_o")) {
      plan.sends.push_back({&stream, out});
      used.insert(out + "_valid_o");
    }
  }
  for (const Filled& filled : kFilled) {
    if (filled.unit == unit_of(model)) plan.fills = &need_stream(vectors, filled.stream);
  }
  for (const auto& [name, port] : model.ports()) {
    const std::size_t end = name.rfind("_valid_");
    if (end == std::string::npos || used.count(name) || is_idle(model, name.substr(0, end))) continue;
    need_stream(vectors, name.substr(0, end));
    throw Error(model.title() + ": nobody knows what to do with port " + name + "; tell tb/harness/units.cpp");
  }
  return plan;
}

Segment segment_of(const Stream& stream, std::size_t frame, const std::string& note = "") {
  std::size_t begin = 0;
  for (std::size_t f = 0; f < frame; ++f) begin += stream.frame_words[f];
  return {&stream, begin, begin + stream.frame_words[frame], frame, note};
}

// A unit on its bench, with the state that lasts from frame to frame.
class UnitBench {
 public:
  UnitBench(Model* model, const Vectors& vectors, const Options& options)
      : plan_(plan_of(*model, vectors)),
        vectors_(vectors),
        options_(options),
        bench_(model, &vectors, &options, unit_of(*model)) {
    for (const Plan::End& end : plan_.loads) loaders_.push_back(&bench_.add_sender(*end.stream, end.port));
    for (const Plan::End& end : plan_.takes) senders_.push_back(&bench_.add_sender(*end.stream, end.port));
    for (const Plan::End& end : plan_.sends) receivers_.push_back(&bench_.add_receiver(*end.stream, end.port));
    const auto add = [&](const MemoryPorts& ports) {
      has_memory_ = has_memory_ || Memory::fits(*model, ports);
      return Memory::fits(*model, ports) ? &bench_.add_memory(ports) : nullptr;
    };
    index_buffer_ = add(kIndexBuffer);
    scanned_ = add(kScannedIndexBuffer);
    shading_ = add(kShadingDatabase);
    add(kDepthBuffer);
    add(kVisibilityDatabase);
  }

  Result run() {
    const Stopwatch stopwatch;
    bench_.reset();
    if (scanned_) {
      run_scan();
    } else if (follows()) {
      for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) send_frame(frame);
      finish_frame();
    } else {
      for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
        if (!run_frame(frame)) break;
      }
    }
    Result result;
    result.unit = bench_.name();
    result.cycles = cycles_;
    result.cycles_of = "all frames, first to last word, stalls included";
    bench_.finish(&result);
    stopwatch.stop(&result);
    return result;
  }

 private:
  // Where nothing is told or stored a frame, words of the next one come at once.
  bool follows() {
    const Model& model = bench_.model();
    return !has_memory_ && plan_.loads.empty() && plan_.registers.empty() && !model.find("frame_width_i") &&
           !model.find("background_i");
  }

  bool run_frame(std::size_t frame) {
    bench_.set_frame(vectors_.frames[frame]);
    // A frame finds its bank of the I-buffer empty; the other one keeps the frame before.
    if (index_buffer_) index_buffer_->clear(int(frame % 2));
    if (!prepare(frame)) return false;
    send_frame(frame);
    return finish_frame();
  }

  void send_frame(std::size_t frame) {
    for (std::size_t i = 0; i < senders_.size(); ++i) senders_[i]->send(segment_of(*plan_.takes[i].stream, frame));
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      receivers_[i]->expect(segment_of(*plan_.sends[i].stream, frame));
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
    const auto port = [this](const char* name) { return &bench_.model().need(name, 1); };
    const Wires wires{port("start_clear_i"), port("start_valid_i"), port("start_ready_o")};
    Sender& start = bench_.add_sender(wires, "start");

    scanned_->clear(0);
    bool tried_clear = false;
    for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
      bench_.set_frame(vectors_.frames[frame]);
      if (!prepare(frame)) return;
      start.send({&tokens_, 0, 1, frame, ""});
      receivers_[0]->expect(segment_of(scan, frame));
      if (!finish_frame()) return;
      start.send({&tokens_, 0, 1, frame, ""});
      receivers_[0]->expect(segment_of(cleared_, frame, kSecondScan));
      if (!finish_extra(options_.hang)) return;
      if (tried_clear || need_stream(vectors_, "update").frame_words[frame] == 0) continue;
      tried_clear = true;
      if (!prepare(frame)) return;
      start.send({&tokens_, 1, 2, frame, ""});
      start.send({&tokens_, 0, 1, frame, ""});
      receivers_[0]->expect(segment_of(cleared_, frame, kScanAfterClear));
      if (!finish_extra(std::max(options_.hang, kClearPatience))) return;
    }
  }

  // Registers, memories and what the unit loads.
  bool prepare(std::size_t frame) {
    for (const Plan::End& end : plan_.registers) {
      const Segment words = segment_of(*end.stream, frame);
      if (words.begin == words.end) continue;
      const Port& port = bench_.model().need(end.port + "_i", end.stream->bits);
      std::memcpy(port.data, end.stream->words[words.end - 1], std::size_t(port.bytes));
    }
    if (scanned_) fill_index_buffer(segment_of(*plan_.fills, frame));
    if (shading_) fill_shading_database(segment_of(*plan_.fills, frame));
    for (std::size_t i = 0; i < loaders_.size(); ++i) loaders_[i]->send(segment_of(*plan_.loads[i].stream, frame));
    const bool loaded = bench_.run([this] { return bench_.all_done(); }, options_.hang);
    bench_.idle(1);
    return loaded;
  }

  void fill_index_buffer(const Segment& updates) {
    const auto field = [&](const char* name) { return updates.stream->need(name, "the bench of scan_index"); };
    const Field x = field("x"), y = field("y"), index = field("index"), mask = field("mask");
    const std::size_t stamps_x =
        std::size_t(bench_.model().constant("MaxWidth") + vectors_.lanes_x - 1) / vectors_.lanes_x;
    for (std::size_t n = updates.begin; n < updates.end; ++n) {
      const std::uint32_t* const word = updates.stream->words[n];
      const std::uint32_t stored[] = {std::uint32_t(index.raw(word)), 0};
      scanned_->write(0, y.raw(word) * stamps_x + x.raw(word), extract(word, mask.lsb, mask.count), vectors_.lanes(),
                      stored, false);
    }
  }

  // The banks take turns with the frames. A word is `last`, `empty`, index and what is stored at index - 1.
  void fill_shading_database(const Segment& planes) {
    const auto field = [&](const char* name) { return planes.stream->need(name, "the bench of a shader"); };
    const Field last = field("last"), empty = field("empty"), index = field("index");
    bench_.model().need(kShadingDatabase.read_data, planes.stream->bits - last.width - empty.width - index.width);
    for (std::size_t n = planes.begin; n < planes.end; ++n) {
      const std::uint32_t* const word = planes.stream->words[n];
      if (!empty.raw(word)) shading_->write(shading_bank_, index.raw(word) - 1, 1, 1, word, true);
      if (last.raw(word)) shading_bank_ ^= 1;
    }
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

  const Plan plan_;
  const Vectors& vectors_;
  const Options& options_;
  Bench bench_;
  std::vector<Sender*> loaders_, senders_;
  std::vector<Receiver*> receivers_;
  bool has_memory_ = false;
  Memory *index_buffer_ = nullptr, *scanned_ = nullptr, *shading_ = nullptr;
  int shading_bank_ = 0;
  std::uint64_t cycles_ = 0;
  Stream cleared_, tokens_;  // of run_scan; the bench points to them until its end
};

}  // namespace

std::vector<std::string> unit_streams(const Model& model, const Vectors& vectors) {
  std::vector<std::string> streams;
  for (const Stream* const stream : plan_of(model, vectors).streams()) streams.push_back(stream->name);
  return streams;
}

Result run_unit(Model* model, const Vectors& vectors, const Options& options) {
  return UnitBench(model, vectors, options).run();
}

}  // namespace halfspace::tb
