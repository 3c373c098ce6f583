// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/units.hpp"

#include <algorithm>
#include <cstring>

#include "tb/film/kept.hpp"
#include "tb/harness/plan.hpp"
#include "tb/report/unit_work.hpp"
#include "tb/report/watch.hpp"

namespace halfspace::tb {
namespace {

// Of frames: half follow the one before at once if they may, an eighth is sent once more right behind itself. So a unit
// sees the first words of a frame behind the last of another, and an end where none comes.
constexpr unsigned kFollow = 4, kRepeat = 1, kOf = 8;
constexpr int kPause = 64;  // cycles after a frame in which a surplus word shows
// A pass that clears the whole buffer sends nothing for as many cycles as the largest frame has stamps.
constexpr std::uint64_t kClearPatience = 4'000'000;
constexpr const char* kSecondScan = " (second scan: the first one has to leave the I-buffer cleared)";
constexpr const char* kScanAfterClear = " (scan after a token with start_clear_i)";

// How many frames are tried behind a reset, and then a long one: what a reset left shows in some only.
unsigned turns_of(const Vectors& vectors) { return vectors.frames.size() < 16 ? 1 : 8; }
constexpr std::size_t kLong = 4096;  // words of a long one, at most

// A unit on its bench, with the state that lasts from frame to frame.
class UnitBench {
 public:
  UnitBench(Model* model, const Vectors& vectors, const Options& options)
      : plan_(plan_of(*model, vectors)),
        vectors_(vectors),
        options_(options),
        bench_(model, &vectors, &options, unit_of(*model)),
        random_(seed_of(options.seed, "frames")) {
    for (const Plan::End& end : plan_.loads) loaders_.push_back(&bench_.add_sender(*end.stream, end.port));
    for (const Plan::End& end : plan_.takes) senders_.push_back(&bench_.add_sender(*end.stream, end.port));
    for (const Plan::End& end : plan_.sends) receivers_.push_back(&bench_.add_receiver(*end.stream, end.port));
    const auto add = [&](const MemoryPorts& ports) {
      return Memory::fits(*model, ports) ? &bench_.add_memory(ports) : nullptr;
    };
    index_buffer_ = add(kIndexBuffer);
    scanned_ = add(kScannedIndexBuffer);
    shading_ = add(kShadingDatabase);
    add(kDepthBuffer);
    add(kVisibilityDatabase);
    add(kMotionBuffer);
    kept_ = Kept{add(kHoleMarks), add(kKeyFrames), add(kFilmBuffer)};
    if (model->find("show_valid_i")) {
      tokens_.name = "show";
      clears_ = &model->need("film_write_en_o", 1);
      const auto port = [&](const char* name, int bits) { return &model->need(name, bits); };
      shows_ = &bench_.add_sender({port("show_i", 2), port("show_valid_i", 1), port("show_ready_o", 1)}, "show");
      tokens_.words = Words(2);
      for (std::uint32_t token = 0; token < 4; ++token) *tokens_.words.append() = token;
    }
    bench_.keep_zero(plan_.zeros);
    const auto watch = [this](auto watched) { bench_.on_cycle([watched]() mutable { return watched.wrong(); }); };
    if (index_buffer_) watch(ZtestWatch(*model, vectors));
    if (NoneLeftWatch::fits(*model, vectors)) watch(NoneLeftWatch(*model, vectors));
  }

  void run(Result* result) {
    const Stopwatch stopwatch;
    bench_.reset();
    if (scanned_) {
      run_scan();
    } else if (follows()) {
      for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) send_frame(frame);
      finish_frame();
    } else {
      run_frames();
    }
    result->unit = bench_.name();
    result->cycles = cycles_;
    result->cycles_of = "all frames, first to last word, stalls included";
    result->repeated = repeated_;
    bench_.finish(result);
    stopwatch.stop(result);
  }

  // A frame with words at every end, any from `turn` shares of the set on, behind them a long one: until a cycle in the
  // midst of it, or all.
  void run_part(bool whole, unsigned turn, const std::string& note, Result* result) {
    result->unit = bench_.name();
    bench_.reset();
    const std::size_t frames = vectors_.frames.size();
    std::size_t frame = turn == turns_of(vectors_) ? long_frame() : frames * turn / turns_of(vectors_);
    for (std::size_t n = 0; n < frames && !has_words(frame); ++n) frame = (frame + 1) % frames;
    const std::uint64_t some = 8 + Random(seed_of(options_.seed + turn, "part")).next() % 512;
    const auto is_there = [&] { return bench_.all_done() || (!whole && bench_.cycle() > some); };
    bench_.set_frame(vectors_.frames[frame]);
    if (index_buffer_) index_buffer_->clear(0);
    if (scanned_) scanned_->clear(0);
    if (prepare(frame)) {
      if (scanned_) {
        add_start().send({&tokens_, 0, 1, frame, ""});
      }
      send_frame(frame);
      bench_.run(is_there, options_.hang);
      if (whole) bench_.idle(kPause);
    }
    bench_.abandon(note, result);
  }

 private:
  // What ztest_merge is to do is a word of a stream, so its runs follow each other at once. Others see the end of each
  // frame: a unit that then waits for a word of the next one hangs.
  bool follows() { return bench_.model().find("merge_valid_i") != nullptr; }

  std::size_t stamps_x() const {
    return std::size_t(bench_.model().constant("MaxWidth") + vectors_.lanes_x - 1) / vectors_.lanes_x;
  }

  void run_frames() {
    for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
      const bool stalls = options_.stall != 0 && stands_alone();  // or each frame is measured alone
      const bool follows = frame > 0 && stalls && draw(kFollow) && may_follow(frame);
      if (!(follows ? leave_one() : finish_frame()) || !begin_frame(frame, follows)) return;
      if (!stalls || idles(frame) || !draw(kRepeat)) continue;
      repeated_.push_back(frame);
      if (!leave_one() || !begin_frame(frame, true)) return;
    }
    finish_frame();
  }

  // Of a film: what the unit finds is not of the pass before.
  bool stands_alone() {
    return !vectors_.is_film() ||
           (!bench_.model().find("fill_i") && !bench_.model().find("key_weight_i") && shows_ == nullptr);
  }

  bool draw(unsigned share) { return random_.next() % kOf < share; }

  bool has_words(std::size_t frame) const {
    const auto some = [&](const Plan::End& end) { return end.stream->frame_words[frame] != 0; };
    return std::all_of(plan_.takes.begin(), plan_.takes.end(), some) &&
           std::all_of(plan_.sends.begin(), plan_.sends.end(), some);
  }

  std::size_t long_frame() const {
    std::size_t best = 0, most = 0;
    for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
      std::size_t words = 0;
      for (const auto* const list : {&plan_.takes, &plan_.sends}) {
        for (const Plan::End& end : *list) words += end.stream->frame_words[frame];
      }
      if (!has_words(frame) || words <= most || words > kLong) continue;
      best = frame;
      most = words;
    }
    return best;
  }

  // Whether what stays for a frame, where the unit has it, is the same in the one before.
  bool may_follow(std::size_t frame) {
    const auto same = [&](const Plan::End& end) { return same_words(*end.stream, frame - 1, frame); };
    const bool has_size = bench_.model().find("frame_width_i"), has_background = bench_.model().find("background_i");
    return ((!has_size && !has_background) || same_registers(vectors_.frames[frame - 1], vectors_.frames[frame])) &&
           std::all_of(plan_.registers.begin(), plan_.registers.end(), same) &&
           std::all_of(plan_.loads.begin(), plan_.loads.end(), same);
  }

  // Two frames at most are on their way, as in the pipeline.
  bool leave_one() {
    const std::uint64_t before = bench_.cycle();
    const bool finished = begun_ < 2 || bench_.run([this] { return bench_.done(begun_ - 1); }, options_.hang);
    cycles_ += bench_.cycle() - before;
    return finished;
  }

  bool begin_frame(std::size_t frame, bool follows) {
    frame_ = vectors_.frames[frame];
    if (!follows) bench_.set_frame(frame_);
    // A frame finds its bank of the I-buffer empty; the other one keeps the frame before.
    if (idles(frame)) return follows || prepare(frame);
    if (index_buffer_) index_buffer_->clear(int(begun_ % 2));
    ++begun_;
    if (follows) {
      if (shading_) fill_shading_database(segment_of(*plan_.fills, frame));
    } else if (!prepare(frame)) {
      return false;
    }
    send_frame(frame);
    return true;
  }

  // A pass of a film in which the unit has nothing to do: it is the turn of others.
  bool idles(std::size_t frame) const {
    return vectors_.is_film() && std::all_of(plan_.sends.begin(), plan_.sends.end(),
                                             [&](const Plan::End& end) { return end.stream->frame_words[frame] == 0; });
  }

  void send_frame(std::size_t frame) {
    begin_work(frame);
    for (std::size_t i = 0; i < senders_.size(); ++i) senders_[i]->send(segment_of(*plan_.takes[i].stream, frame));
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      receivers_[i]->expect(segment_of(*plan_.sends[i].stream, frame));
    }
    if (shows_ == nullptr) return;
    for (const std::uint32_t token : kept_.shows(vectors_, frame)) {
      shows_->send({&tokens_, token, token + 1, frame, ""});
      shown_.push_back(token);
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
    Sender& start = add_start();

    scanned_->clear(0);
    bool tried_clear = false;
    for (std::size_t frame = 0; frame < vectors_.frames.size(); ++frame) {
      bench_.set_frame(vectors_.frames[frame]);
      if (!prepare(frame)) return;
      begin_work(frame);
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

  Sender& add_start() {
    tokens_.name = "start";
    tokens_.words = Words(1);
    tokens_.words.append();
    *tokens_.words.append() = 1;
    const auto port = [this](const char* name) { return &bench_.model().need(name, 1); };
    const Wires wires{port("start_clear_i"), port("start_valid_i"), port("start_ready_o")};
    starts_ = wires.ready;
    return bench_.add_sender(wires, "start");
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
    kept_.prepare(bench_.model(), vectors_, frame);
    for (std::size_t i = 0; i < loaders_.size(); ++i) loaders_[i]->send(segment_of(*plan_.loads[i].stream, frame));
    const bool loaded = loaders_.empty() || bench_.run([this] { return bench_.all_done(); }, options_.hang);
    bench_.idle(1);
    return loaded;
  }

  void fill_index_buffer(const Segment& updates) {
    const auto field = [&](const char* name) { return updates.stream->need(name, "the bench of scan_index"); };
    const Field x = field("x"), y = field("y"), index = field("index"), mask = field("mask");
    for (std::size_t n = updates.begin; n < updates.end; ++n) {
      const std::uint32_t* const word = updates.stream->words[n];
      const std::uint32_t stored[] = {std::uint32_t(index.raw(word)), 0};
      scanned_->write(0, y.raw(word) * stamps_x() + x.raw(word), extract(word, mask.lsb, mask.count), vectors_.lanes(),
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

  // What they take of the size goes with a word that they take: it may change behind the last.
  bool reads_size_with_words() const { return bench_.name() == "triangle_setup" || bench_.name() == "raster_pineda"; }

  bool finish_frame() {
    if (begun_ == 0 && !scanned_ && !follows()) return true;
    const std::uint64_t before = bench_.cycle();
    bool taken = true;
    if (reads_size_with_words()) {
      taken = bench_.run([this] { return bench_.all_taken(); }, options_.hang);
      Frame other = frame_;
      other.width = 1 + random_.next() % frame_.width;
      other.height = 1 + random_.next() % frame_.height;
      bench_.set_frame(other);
    }
    const bool finished = taken && bench_.run([this] { return ends(); }, options_.hang);
    cycles_ += bench_.cycle() - before;
    if (finished) check_interval();
    bench_.idle(kPause);
    return finished;
  }

  // Frame control gives a bank away as soon as scan_index takes the token of the next pass.
  bool ends() {
    if (starts_ && *starts_->bit() != 0 && *receivers_[0]->wires().valid->bit() != 0)
      bench_.fail("protocol: start is taken before the last word of the pass before");
    // The next frame may be in the film buffer while a key frame is shown.
    if (shows_ && shows_->words() != 0 && shown_[shows_->words() - 1] < 2 && *clears_->bit() != 0)
      bench_.fail("protocol: the film buffer is cleared while a key frame is shown");
    return bench_.all_done();
  }

  void begin_work(std::size_t frame) {
    due_.add(frame, unit_work(bench_.model(), vectors_, frame, bench_.cycle()), follows(), waits());
  }

  // All that was sent is through.
  void check_interval() {
    if (const std::string why = due_.slow(waits()); !why.empty()) bench_.fail(why);
  }
  Waits waits() const { return {bench_.cycle(), bench_.stalled(), bench_.late()}; }

  // Passes that no frame asks for do not count as its cycles.
  bool finish_extra(std::uint64_t patience) {
    const bool finished = bench_.run([this] { return ends(); }, patience);
    bench_.idle(kPause);
    return finished;
  }

  const Plan plan_;
  const Vectors& vectors_;
  const Options& options_;
  Bench bench_;
  std::vector<Sender*> loaders_, senders_;
  std::vector<Receiver*> receivers_;
  Memory *index_buffer_ = nullptr, *scanned_ = nullptr, *shading_ = nullptr;
  Kept kept_;
  Sender* shows_ = nullptr;
  const Port* starts_ = nullptr;  // of scan_index: whether it takes a token
  const Port* clears_ = nullptr;  // of film_scan, and its tokens
  std::vector<std::uint32_t> shown_;
  int shading_bank_ = 0;
  std::uint64_t cycles_ = 0;
  Random random_;
  std::size_t begun_ = 0;  // frames
  Frame frame_{};          // the last of these
  std::vector<std::size_t> repeated_;
  DueWork due_;
  Stream cleared_, tokens_;  // of run_scan, or of shows_; the bench points to them until its end
};

}  // namespace

std::vector<std::string> unit_streams(const Model& model, const Vectors& vectors) {
  std::vector<std::string> streams;
  for (const Stream* const stream : plan_of(model, vectors).streams()) streams.push_back(stream->name);
  return streams;
}

Result run_unit(const Vectors& vectors, const Options& options) {
  Result result;
  const auto found = [&] { return options.mutant != 0 && !result.passed(); };
  for (const Start start : {Start::kZeros, Start::kOnes}) {
    const char* const note = start == Start::kZeros ? " (all registers 0 at first)" : " (all registers 1 at first)";
    for (unsigned turn = 0; turn < turns_of(vectors) && !found(); ++turn) {
      const std::unique_ptr<Model> model = make_model(options.seed, start);
      UnitBench(model.get(), vectors, options).run_part(true, turn, note, &result);
    }
  }
  if (found()) return result;
  const std::unique_ptr<Model> model = make_model(options.seed, Start::kRandom);
  for (unsigned turn = 0; turn <= turns_of(vectors); ++turn)
    UnitBench(model.get(), vectors, options).run_part(false, turn, " (a frame that a reset ends)", &result);
  UnitBench(model.get(), vectors, options).run(&result);
  return result;
}

}  // namespace halfspace::tb
