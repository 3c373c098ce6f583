// SPDX-License-Identifier: Apache-2.0
#include "tb/composed/static_frames.hpp"

#include <cstring>
#include <memory>
#include <random>
#include <unordered_map>

#include "tb/harness/pipeline.hpp"
#include "tb/harness/plan.hpp"

namespace halfspace::tb {
namespace {

constexpr int kPause = 64;

// The memory of the D-buffer and of the S-buffers. A place is answered with what is there when it is taken, in a later
// cycle, the answers in order; what nobody wrote is random.
class BufferMemory {
 public:
  BufferMemory(const Vectors& vectors, std::uint64_t seed)
      : place_(need_stream(vectors, "stored_place").bits),
        pixels_(need_stream(vectors, "stored_pixels").bits),
        random_(seed) {}

  // One pair of streams: places that are seen, and a sender that answers.
  void serve(Receiver& places, Bench& bench, const Stream& answers) {
    Answers& port = *ports_.emplace_back(std::make_unique<Answers>());
    port.stream = answers;
    port.stream.words = Words(pixels_);
    port.sender = &bench.add_sender(port.stream);
    places.on_word([this, &port](const std::uint32_t* word) {
      const std::vector<std::uint32_t>& there = at(extract(word, 0, place_));
      std::memcpy(port.stream.words.append(), there.data(), there.size() * 4);
      const std::size_t n = port.stream.words.size();
      port.sender->send({&port.stream, n - 1, n, 0, ""});
    });
  }
  void keep(Receiver& kept) {
    kept.on_word([this](const std::uint32_t* word) {
      copy_bits(at(extract(word, pixels_, place_)).data(), 0, word, 0, pixels_);
    });
  }

 private:
  struct Answers {
    Stream stream;
    Sender* sender = nullptr;
  };

  std::vector<std::uint32_t>& at(std::uint64_t place) {
    std::vector<std::uint32_t>& stamp = stamps_[place];
    if (stamp.empty()) {
      stamp.resize(std::size_t(pixels_ + 31) / 32);
      for (int bit = 0; bit < pixels_; ++bit) stamp[std::size_t(bit) / 32] |= std::uint32_t(random_() & 1) << bit % 32;
    }
    return stamp;
  }

  const int place_, pixels_;  // bits
  std::mt19937_64 random_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> stamps_;
  std::vector<std::unique_ptr<Answers>> ports_;
};

class StaticFramesBench {
 public:
  StaticFramesBench(Model* model, const Vectors& vectors, const Options& options)
      : vectors_(vectors),
        options_(options),
        bench_(model, &vectors, &options, unit_of(*model)),
        busy_(model->need("busy_o", 1).bit()),
        memory_(vectors, options.seed) {
    for (const Stream& stream : vectors.streams) {
      if (stream.from == "memory") continue;
      if (is_loaded(stream)) {
        loads_.emplace_back(&stream, &bench_.add_sender(stream));
      } else if (stream.name == "triangle" || stream.name == "command" || is_answer(stream)) {
        senders_.emplace_back(&stream, &bench_.add_sender(stream));
        if (stream.name == "triangle" && vectors.window != 0) senders_.back().second->hold(&triangles_);
        if (is_answer(stream)) senders_.back().second->hold(&answers_);
        if (stream.name == "triangle") triangle_ = senders_.back().second;
      } else {
        receivers_.emplace_back(&stream, &bench_.add_receiver(stream));
      }
    }
    triangles_ = vectors.window;
    listen();
  }

  Result run() {
    const Stopwatch stopwatch;
    bench_.reset();
    bool ran = true;
    for (std::size_t first = 0; first < vectors_.frames.size() && ran;) {
      std::size_t end = first + 1;
      while (end < vectors_.frames.size() && may_follow(vectors_, first, end)) ++end;
      ran = run_frames(first, end);
      first = end;
    }
    Result result;
    result.unit = bench_.name();
    bench_.finish(&result);
    stopwatch.stop(&result);
    const Model& model = bench_.model();
    result.bound = bound_of(vectors_, model, model.constant("SetupInterval"), 0, vectors_.frames.size());
    result.bound.merges = need_stream(vectors_, "stored").words.size();
    const std::vector<std::uint64_t>& ends = shown_->end_cycles();
    result.cycles = ends.empty() ? bench_.cycle() : ends.back() - begin_ + 2;
    result.cycles_of = "all frames, first triangle to last stamp shown";
    return result;
  }

 private:
  void listen() {
    for (const auto& [stream, receiver] : receivers_) {
      if (stream->name == "visible") {
        const Field& visible = stream->need("visible", "the answers of geometry");
        receiver->on_word([this, &visible](const std::uint32_t* word) {
          ++triangles_;
          answers_ += visible.raw(word) != 0;
        });
      }
      if (stream->name == "stored_place") memory_.serve(*receiver, bench_, need_stream(vectors_, "stored_pixels"));
      if (stream->name == "drawn_place") memory_.serve(*receiver, bench_, need_stream(vectors_, "drawn_pixels"));
      if (stream->name == "kept") memory_.keep(*receiver);
      if (stream->name == "shown") shown_ = receiver;
    }
    if (triangle_ == nullptr || shown_ == nullptr) {
      throw Error(vectors_.directory +
                  "/manifest.json: lacks triangle or shown; make it with `halfspace vectors "
                  "static_frames`");
    }
  }

  bool run_frames(std::size_t first, std::size_t end) {
    bench_.set_frame(vectors_.frames[first]);
    for (const auto& [stream, sender] : loads_) sender->send(segment_of(*stream, first));
    bool ran = loads_.empty() || bench_.run([this] { return bench_.all_done(); }, options_.hang);
    bench_.idle(1);
    for (std::size_t frame = first; frame < end; ++frame) {
      for (const auto& [stream, sender] : senders_) sender->send(segment_of(*stream, frame));
      for (const auto& [stream, receiver] : receivers_) receiver->expect(segment_of(*stream, frame));
    }
    if (first == 0) {
      ran = ran && bench_.run([this] { return triangle_->words() > 0; }, kResetPatience);
      begin_ = bench_.cycle();
    }
    ran = ran && bench_.run([this] { return bench_.all_done() && *busy_ == 0; }, options_.hang);
    bench_.idle(kPause);
    return ran;
  }

  const Vectors& vectors_;
  const Options& options_;
  Bench bench_;
  const std::uint8_t* busy_;
  BufferMemory memory_;
  std::vector<std::pair<const Stream*, Sender*>> senders_, loads_;
  std::vector<std::pair<const Stream*, Receiver*>> receivers_;
  Sender* triangle_ = nullptr;
  Receiver* shown_ = nullptr;
  std::size_t triangles_ = 0, answers_ = 0;  // as many may be sent
  std::uint64_t begin_ = 0;                  // the cycle after the first triangle
};

}  // namespace

Result run_static_frames(Model* model, const Vectors& vectors, const Options& options) {
  if (options.seed % 2 == 0) run_part(model, vectors, options);
  return StaticFramesBench(model, vectors, options).run();
}

}  // namespace halfspace::tb
