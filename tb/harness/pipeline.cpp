// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/pipeline.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

#include "tb/report/setup_work.hpp"

namespace halfspace::tb {
namespace {

constexpr int kPause = 64;

// A frame as often as it is drawn.
struct Turn {
  std::size_t frame;
  std::string note;
};

std::vector<Turn> turns_of(const Vectors& vectors, int times_last) {
  std::vector<Turn> turns;
  for (std::size_t frame = 0; frame + 1 < vectors.frames.size(); ++frame) turns.push_back({frame, ""});
  for (int time = 1; time <= times_last; ++time) {
    const std::string note =
        times_last == 1 ? "" : " (time " + std::to_string(time) + " of " + std::to_string(times_last) + ")";
    turns.push_back({vectors.frames.size() - 1, note});
  }
  return turns;
}

Segment segment_of(const Stream& stream, const Turn& turn) { return segment_of(stream, turn.frame, turn.note); }

// Of frames [first, end).
Segment segment_of(const Stream& stream, std::size_t first, std::size_t end) {
  return {&stream, segment_of(stream, first).begin, segment_of(stream, end - 1).end, first, ""};
}

}  // namespace

bool is_loaded(const Stream& stream) { return stream.from == "host"; }
bool is_answer(const Stream& stream) { return stream.from == "geometry" && stream.name != "triangle"; }

bool may_follow(const Vectors& vectors, std::size_t a, std::size_t b) {
  return same_registers(vectors.frames[a], vectors.frames[b]) &&
         std::all_of(vectors.streams.begin(), vectors.streams.end(),
                     [&](const Stream& stream) { return !is_loaded(stream) || same_words(stream, a, b); });
}

std::uint64_t serial_pixels(const Stream& scan, std::size_t first, std::size_t end, std::uint64_t turns) {
  const Field& index = scan.need("index", "the bound of cycles");
  const Segment words = segment_of(scan, first, end);
  std::uint64_t serial = 0;
  for (std::size_t n = words.begin; n < words.end && turns != 0; ++n) {
    std::uint64_t covered = 0;
    for (int lane = 0; lane < index.count; ++lane) covered += index.raw(scan.words[n], lane) != 0;
    serial += std::max<std::uint64_t>(covered, 1) * turns;
  }
  return serial;
}

Bound bound_of(const Vectors& vectors, const Model& model, int setup_interval, std::size_t first, std::size_t end) {
  Bound bound;
  if (const Stream* const setup = vectors.find("setup")) {
    for (std::size_t frame = first; frame < end; ++frame) {
      const std::size_t begin = segment_of(*setup, frame).begin;
      bound.setup += setup_work(vectors, setup->words, begin, frame, std::uint64_t(setup_interval)).cycles;
    }
  }
  if (const Stream* const scan = vectors.find("scan")) {
    for (std::size_t frame = first; frame < end; ++frame) bound.pixels += scan->frame_words[frame];
    // The lights of each pixel.
    const int turns = model.constant("Phong")                                       ? model.constant("Lights")
                      : model.constant("HasTexture") || model.constant("HasMotion") ? 1
                                                                                    : 0;
    bound.pixels = std::max(bound.pixels, serial_pixels(*scan, first, end, std::uint64_t(turns)));
  }
  if (const Stream* const stamp = vectors.find("stamp")) {
    const Field& mask = stamp->need("mask", "the bound of cycles");
    const Segment words = segment_of(*stamp, first, end);
    for (std::size_t n = words.begin; n < words.end; ++n) {
      bound.stamps += extract(stamp->words[n], mask.lsb, mask.width * mask.count) != 0;
    }
  }
  return bound;
}

namespace {

// What serves the clients of a model with memory outside.
std::unique_ptr<Clients> memory_of(Model* model, const Options& options, Bench* bench) {
  if (!Clients::fits(*model)) return nullptr;
  auto clients = std::make_unique<Clients>(model, seed_of(options.seed, "memory"), options.outside_latency);
  bench->add_partner(clients.get());
  return clients;
}

}  // namespace

void run_part(Model* model, const Vectors& vectors, const Options& options) {
  Bench bench(model, &vectors, &options, "pipeline");
  const std::uint64_t some = 32 + Random(options.seed).next() % 1024;
  std::size_t frame = 0;
  while (frame + 1 < vectors.frames.size() && vectors.find("triangle")->frame_words[frame] < 2) ++frame;
  bench.reset();
  bench.set_frame(vectors.frames[frame]);
  const auto memory = memory_of(model, options, &bench);
  for (const auto& [name, port] : model->ports()) {
    if (port.input && port.bits == 1 && name.rfind("_ready_i") != std::string::npos) model->set(name, 1);
  }
  for (const Stream& stream : vectors.streams) {
    if (is_loaded(stream)) bench.add_sender(stream).send(segment_of(stream, frame));
  }
  bench.run([&] { return bench.all_done(); }, options.hang);
  Sender& triangles = bench.add_sender(*vectors.find("triangle"));
  triangles.send(segment_of(*vectors.find("triangle"), frame));
  bench.run([&] { return triangles.words() > 0; }, kResetPatience);
  bench.idle(int(some));
  for (const auto& [name, port] : model->ports()) {
    if (port.input && name != "clk_i") model->set(name, 0);
  }
}

namespace {

// What geometry has heard of the triangles, and may send for it.
struct Geometry {
  std::size_t triangles = 0;  // the triangle after a window of those whose results are known
  std::size_t answers = 0;    // a word for each visible one
};

}  // namespace

Result run_pipeline(Model* model, const Vectors& vectors, const Options& options, LastFrame* last) {
  // Clearing takes longer than small frames: every other seed.
  if (options.seed % 2 == 0) run_part(model, vectors, options);
  Bench bench(model, &vectors, &options, "pipeline");
  const auto memory = memory_of(model, options, &bench);
  const std::uint8_t* const busy = model->need("busy_o", 1).bit();
  Sender* triangles = nullptr;
  std::vector<std::pair<const Stream*, Sender*>> senders, loads;
  Geometry geometry;
  geometry.triangles = vectors.window;
  std::vector<std::pair<const Stream*, Receiver*>> receivers;
  const char* const end_name = vectors.shown();  // ends a frame
  Receiver* pixel = nullptr;
  bool scans = false;
  for (const Stream& stream : vectors.streams) {
    if (stream.name == "triangle" || is_answer(stream)) {
      Sender& sender = bench.add_sender(stream);
      senders.emplace_back(&stream, &sender);
      if (stream.name == "triangle") triangles = &sender;
      else sender.hold(&geometry.answers);
      continue;
    }
    if (is_loaded(stream)) {
      loads.emplace_back(&stream, &bench.add_sender(stream));
      continue;
    }
    receivers.emplace_back(&stream, &bench.add_receiver(stream));
    if (stream.name == end_name) pixel = receivers.back().second;
    if (stream.name == "visible") {
      const Field& visible = stream.need("visible", "the answers of geometry");
      receivers.back().second->on_word([&geometry, &visible](const std::uint32_t* word) {
        ++geometry.triangles;
        geometry.answers += visible.raw(word) != 0;
      });
    }
    scans = scans || stream.name == "scan";
  }
  if (triangles == nullptr || pixel == nullptr || !scans) {
    throw Error(vectors.directory + "/manifest.json: lacks one of the streams triangle, scan and " + end_name +
                "; make the set again");
  }

  if (vectors.window != 0) triangles->hold(&geometry.triangles);

  if (!options.json.empty()) bench.keep_timeline();
  const Stopwatch stopwatch;
  bench.reset();
  const std::vector<Turn> turns = turns_of(vectors, options.frames);
  bool ran = true;
  std::vector<std::size_t> begins;  // the triangles before each frame
  std::size_t sent = 0;
  for (std::size_t first = 0; first < turns.size() && ran;) {
    std::size_t end = first + 1;
    while (end < turns.size() && may_follow(vectors, turns[first].frame, turns[end].frame)) ++end;
    bench.set_frame(vectors.frames[turns[first].frame]);
    for (const auto& [stream, sender] : loads) sender->send(segment_of(*stream, turns[first]));
    if (!loads.empty()) ran = bench.run([&] { return bench.all_done(); }, options.hang);
    bench.idle(1);
    for (std::size_t turn = first; turn < end; ++turn) {
      const Segment frame = segment_of(*vectors.find("triangle"), turns[turn]);
      begins.push_back(sent);
      sent += frame.end - frame.begin;
      for (const auto& [stream, sender] : senders) sender->send(segment_of(*stream, turns[turn]));
      for (const auto& [stream, receiver] : receivers) receiver->expect(segment_of(*stream, turns[turn]));
    }
    if (end == turns.size()) {
      last->pixel = Words(vectors.find(end_name)->bits);
      pixel->record_last(&last->pixel);
      for (const auto& [stream, receiver] : receivers) {
        if (std::find(std::begin(kCountedStreams), std::end(kCountedStreams), stream->name) ==
            std::end(kCountedStreams))
          continue;
        last->counted[stream->name] = Words(stream->bits);
        receiver->record_last(&last->counted[stream->name]);
      }
    }
    const auto done = [&] {
      const auto begun = std::lower_bound(begins.begin(), begins.end(), triangles->words()) - begins.begin();
      if (std::size_t(begun) > pixel->segments_done() && *busy == 0)
        bench.fail("protocol: busy_o is 0 while a frame is in flight");
      return bench.all_done() && *busy == 0;
    };
    if (first == 0)
      ran = ran && bench.run([&] { return triangles->words() > 0; }, std::max(options.hang, kResetPatience));
    ran = ran && bench.run(done, options.hang);
    bench.idle(kPause);
    first = end;
  }

  Result result;
  result.unit = "pipeline";
  bench.finish(&result);
  if (memory) result.clients = memory->counts();
  stopwatch.stop(&result);
  const int chosen = model->constant("SetupCycles");  // a parameter of the module that tb/model.py was given
  const int setup_interval = options.setup_interval ? options.setup_interval
                             : chosen               ? chosen
                                                    : model->constant("SetupInterval");
  result.bound = bound_of(vectors, *model, setup_interval, vectors.frames.size() - 1, vectors.frames.size());
  result.rates = count_rates(vectors, last->counted, model->constant("Bilinear") ? 4 : 1);
  if (const auto setup = last->counted.find("setup");
      setup != last->counted.end() && (model->constant("CullsBack") || model->constant("CullsFront"))) {
    result.rates.culled = setup_work(vectors, setup->second, 0, vectors.frames.size() - 1, 0).culled;
  }
  const auto number = [&](const char* name) { return std::uint64_t(model->constant(name)); };
  result.accesses =
      count_accesses(vectors, last->counted, {number("MaxWidth"), number("MaxHeight"), number("Triangles")});
  const std::vector<std::uint64_t>& ends = pixel->end_cycles();
  result.frame_ends = ends;
  if (options.frames > 1 && ends.size() == turns.size()) {
    result.cycles = ends.back() - ends[ends.size() - 2];
    result.cycles_of = "the last frame, in steady state";
  } else {
    result.cycles = ends.empty() ? bench.cycle() : ends.back() - bench.first_move() + 1;
    result.cycles_of = "all frames, first triangle to last pixel";
  }
  return result;
}

}  // namespace halfspace::tb
