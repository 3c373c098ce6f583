// SPDX-License-Identifier: Apache-2.0
#include "tb/film/film.hpp"

#include <algorithm>
#include <map>

#include "tb/harness/pipeline.hpp"
#include "tb/harness/plan.hpp"

namespace halfspace::tb {
namespace {

constexpr int kPause = 64;
constexpr const char* kPurpose = "the bench of a film";

// A word of `visible` that says so allows a word of each stream that the pass answers with.
class Geometry {
 public:
  explicit Geometry(const Vectors& vectors) : visible_(need_stream(vectors, "visible")) {}

  const std::size_t* allowed(const Stream& stream) { return &answers_[&stream]; }
  const std::size_t* triangles(std::size_t window) {
    triangles_ = window;
    return &triangles_;
  }
  void hear(const std::uint32_t* word) {
    ++triangles_;
    const bool answers = visible_.need("visible", kPurpose).raw(word) != 0;
    for (auto& [stream, allowed] : answers_) {
      allowed += answers && pass_ < stream->frame_words.size() && stream->frame_words[pass_] != 0;
    }
    pass_ += visible_.need("last", kPurpose).raw(word) != 0;
  }

 private:
  const Stream& visible_;
  std::map<const Stream*, std::size_t> answers_;
  std::size_t triangles_ = 0, pass_ = 0;
};

// What is in the memories that are loaded.
class Loaded {
 public:
  // Whether a pass loads other words than there are.
  bool differs(const std::vector<const Stream*>& streams, std::size_t pass) const {
    return std::any_of(streams.begin(), streams.end(), [&](const Stream* stream) {
      if (stream->frame_words[pass] == 0) return false;
      const auto had = last_.find(stream);
      return had == last_.end() || !same_words(*stream, had->second, pass);
    });
  }
  void set(const std::vector<const Stream*>& streams, std::size_t pass) {
    for (const Stream* const stream : streams) {
      if (stream->frame_words[pass] != 0) last_[stream] = pass;
    }
  }

 private:
  std::map<const Stream*, std::size_t> last_;
};

// Frames that come out in a pass.
std::uint64_t frames_of(const Stream& film, std::size_t pass) {
  const Field& last = film.need("last", kPurpose);
  const Segment words = segment_of(film, pass);
  std::uint64_t n = 0;
  for (std::size_t at = words.begin; at < words.end; ++at) n += last.raw(film.words[at]) != 0;
  return n;
}

// What a pass takes by the rates of its units.
void add_pass(const Vectors& vectors, const Model& model, std::size_t pass, FilmBound* bound) {
  const Bound drawn = bound_of(vectors, model, model.constant("SetupInterval"), pass, pass + 1);
  // The lights of each pixel.
  const bool between = vectors.frames[pass].pass == "between";
  const std::uint64_t turns = between                        ? 1
                              : model.constant("Phong")      ? std::uint64_t(model.constant("Lights"))
                              : model.constant("HasTexture") ? 1
                                                             : 0;
  const std::uint64_t serial = serial_pixels(need_stream(vectors, "masked"), pass, pass + 1, turns);
  const std::uint64_t scans = need_stream(vectors, "scan").frame_words[pass];
  const std::uint64_t shown = std::max({scans, serial, std::uint64_t(need_stream(vectors, "shown").frame_words[pass])});
  const std::uint64_t motion = need_stream(vectors, "ordered").frame_words[pass];
  bound->setup += drawn.setup, bound->stamps += drawn.stamps, bound->shader += shown, bound->motion += motion;
  bound->passes += std::max(drawn.setup, drawn.stamps) + shown + motion;
  bound->frames += frames_of(need_stream(vectors, "film"), pass);
  bound->film += need_stream(vectors, "film").frame_words[pass];
}

}  // namespace

Result run_film(Model* model, const Vectors& vectors, const Options& options) {
  if (!vectors.is_film()) {
    throw Error(vectors.directory +
                "/manifest.json: its frames are no passes of a film; make the set with a "
                "configuration that has frames_between");
  }
  Bench bench(model, &vectors, &options, "up_convert");
  const std::uint8_t* const busy = model->need("busy_o", 1).bit();
  Geometry geometry(vectors);
  Sender* triangles = nullptr;
  std::vector<std::pair<const Stream*, Sender*>> senders, loads;
  std::vector<const Stream*> loaded_streams;
  std::vector<std::pair<const Stream*, Receiver*>> receivers;
  const Receiver* film = nullptr;
  for (const Stream& stream : vectors.streams) {
    if (is_loaded(stream)) {
      loads.emplace_back(&stream, &bench.add_sender(stream));
      loaded_streams.push_back(&stream);
    } else if (stream.from == "geometry") {
      Sender& sender = bench.add_sender(stream);
      senders.emplace_back(&stream, &sender);
      if (is_answer(stream)) sender.hold(geometry.allowed(stream));
      else triangles = &sender;
    } else {
      receivers.emplace_back(&stream, &bench.add_receiver(stream));
      if (stream.name == "film") film = receivers.back().second;
      if (stream.name == "visible") {
        receivers.back().second->on_word([&geometry](const std::uint32_t* word) { geometry.hear(word); });
      }
    }
  }
  if (triangles == nullptr || film == nullptr) {
    throw Error(vectors.directory + "/manifest.json: lacks the stream triangle or film; make the set again");
  }
  if (vectors.window != 0) triangles->hold(geometry.triangles(vectors.window));

  const Stopwatch stopwatch;
  bench.reset();
  bench.set_frame(vectors.frames.front());
  Loaded loaded;
  const auto done = [&] { return bench.all_done() && *busy == 0; };
  bool ran = true;
  std::uint64_t begin = 0;
  for (std::size_t pass = 0; pass < vectors.frames.size() && ran; ++pass) {
    if (loaded.differs(loaded_streams, pass)) {
      // K0's come before the design has cleared its I-buffer.
      if (pass > 0) ran = bench.run(done, options.hang);
      for (const auto& [stream, sender] : loads) sender->send(segment_of(*stream, pass));
      loaded.set(loaded_streams, pass);
      ran = ran && bench.run([&] { return bench.all_done(); }, options.hang);
      bench.idle(1);
    }
    for (const auto& [stream, sender] : senders) sender->send(segment_of(*stream, pass));
    for (const auto& [stream, receiver] : receivers) receiver->expect(segment_of(*stream, pass));
    if (pass != 0) continue;
    ran = ran && bench.run([&] { return triangles->words() > 0; }, std::max(options.hang, kResetPatience));
    begin = bench.cycle();
  }
  ran = ran && bench.run(done, options.hang);
  bench.idle(kPause);

  Result result;
  result.unit = "up_convert";
  bench.finish(&result);
  stopwatch.stop(&result);
  for (std::size_t pass = 0; pass < vectors.frames.size(); ++pass) add_pass(vectors, *model, pass, &result.film);
  const std::vector<std::uint64_t>& ends = film->end_cycles();
  result.cycles = ends.empty() ? bench.cycle() : ends.back() - begin + 2;
  result.cycles_of = "the whole film, first triangle to last pixel";
  return result;
}

}  // namespace halfspace::tb
