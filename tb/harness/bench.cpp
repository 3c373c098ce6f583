// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/bench.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "tb/harness/plan.hpp"
#include "tb/report/blame.hpp"

namespace halfspace::tb {

namespace {

// No unit takes more cycles for a word on the average, stalls included: what does never ends by itself.
constexpr std::uint64_t kCyclesAWord = 2000;

}  // namespace

std::size_t Result::words() const {
  std::size_t sum = 0;
  for (const StreamResult& stream : streams) sum += stream.words;
  return sum;
}

std::size_t Result::mismatches() const {
  std::size_t sum = 0;
  for (const StreamResult& stream : streams) sum += stream.mismatches;
  return sum;
}

std::size_t Result::missing() const {
  std::size_t sum = 0;
  for (const StreamResult& stream : streams) sum += stream.missing;
  return sum;
}

Bench::Bench(Model* model, const Vectors* vectors, const Options* options, std::string name)
    : model_(model),
      vectors_(vectors),
      options_(options),
      name_(std::move(name)),
      life_(++lives),
      clock_(model->need("clk_i", 1).bit()) {
  if (model->find("mutant_i")) model->set("mutant_i", options->mutant);
}

// Each unit has its own sequence for a stream; the pipeline has that of the stream's name alone.
std::uint64_t Bench::seed_for(const std::string& part) const {
  return seed_of(options_->seed, name_ == "pipeline" ? part : name_ + "_" + part);
}

Sender& Bench::add_sender(const Stream& stream, const std::string& port) {
  return add_sender(input_wires(*model_, port.empty() ? stream.name : port, stream), stream.name);
}

Sender& Bench::add_sender(const Wires& wires, const std::string& name) {
  return senders_.emplace_back(wires, name, seed_for(name), options_->stall);
}

Receiver& Bench::add_receiver(const Stream& stream, const std::string& port) {
  return receivers_.emplace_back(output_wires(*model_, port.empty() ? stream.name : port, stream), *vectors_,
                                 stream.name, seed_for(stream.name), options_->stall);
}

Memory& Bench::add_memory(const MemoryPorts& ports) {
  return memories_.emplace_back(*model_, ports, seed_for(ports.read_data));
}

void Bench::reset() {
  constexpr int kCycles = 4;
  model_->set("rst_ni", 1);
  *clock_ = 0;
  model_->eval();
  model_->set("rst_ni", 0);
  model_->eval();
  for (int i = 0; i < kCycles; ++i) {
    *clock_ = 1;
    model_->eval();
    *clock_ = 0;
    model_->eval();
  }
  model_->set("rst_ni", 1);
  model_->eval();
}

void Bench::set_frame(const Frame& frame) {
  // Where no unit of this model looks at a register, there is none.
  if (model_->find("frame_width_i")) {
    model_->set("frame_width_i", frame.width);
    model_->set("frame_height_i", frame.height);
  }
  if (model_->find("fill_i")) model_->set("fill_i", frame.pass == "fill");
  if (!frame.pass.empty() && model_->find("key_weight_i")) model_->set("key_weight_i", frame.weight);
  if (!model_->find("background_i")) return;
  const std::uint32_t* const rgb = frame.background;
  const int bits = model_->constant("ColourBits");
  model_->set("background_i", rgb[0] << 2 * bits | rgb[1] << bits | rgb[2]);
}

void Bench::keep_timeline() {
  has_timeline_ = true;
  for (const Sender& sender : senders_) timeline_.add(sender.name());
  for (const Receiver& receiver : receivers_) timeline_.add(receiver.name());
}

// Words that moved are counted by now, and the wires are as they were.
void Bench::note_streams() {
  timeline_.begin(cycle_);
  const auto note = [&](const Wires& wires) {
    timeline_.note(*wires.valid->bit() != 0, wires.ready == nullptr || *wires.ready->bit() != 0);
  };
  for (const Sender& sender : senders_) note(sender.wires());
  for (const Receiver& receiver : receivers_) note(receiver.wires());
}

// The first cycle that is wrong is told.
void Bench::look() {
  if (looked_wrong_) return;
  std::string wrong;
  for (const auto& look : looks_) {
    if (wrong.empty()) wrong = look();
  }
  for (const Port* const port : zeros_) {
    const auto* const bytes = static_cast<const std::uint8_t*>(port->data);
    if (wrong.empty() && std::any_of(bytes, bytes + port->bytes, [](std::uint8_t byte) { return byte != 0; })) {
      wrong = "idle: " + port->name + " is not 0, and the configuration has no such stream";
    }
  }
  if (wrong.empty()) return;
  looked_wrong_ = true;
  failures_.push_back(wrong + ", cycle " + std::to_string(cycle_));
}

bool Bench::step() {
  for (Sender& sender : senders_) sender.drive();
  for (Receiver& receiver : receivers_) receiver.drive();
  for (Partner* partner : partners_) partner->drive();
  *clock_ = 0;
  model_->eval();
  model_->show(life_, cycle_, false);
  look();
  const auto stalls = [](const auto& end) { return end.stalls(); };
  stalled_ += std::any_of(senders_.begin(), senders_.end(), stalls) ||
              std::any_of(receivers_.begin(), receivers_.end(), stalls);
  bool moved = false;
  for (Sender& sender : senders_) moved |= sender.sample();
  for (Receiver& receiver : receivers_) moved |= receiver.sample(cycle_);
  if (has_timeline_ && (moved || first_move_ != 0)) note_streams();
  for (Memory& memory : memories_) memory.sample();
  for (Partner* partner : partners_) {
    partner->sample();
    for (const std::string& what : partner->take_failures()) fail(what);
  }
  *clock_ = 1;
  model_->eval();
  model_->show(life_, cycle_, true);
  for (Memory& memory : memories_) memory.answer();
  if (moved && first_move_ == 0) first_move_ = cycle_;
  moves_ += moved;
  if (moved) last_move_ = cycle_;
  ++cycle_;
  return moved;
}

// A line on standard error every two seconds of a long run.
void Bench::tell_progress() {
  const auto now = std::chrono::steady_clock::now();
  if (now - told_ < std::chrono::seconds(2)) return;
  told_ = now;
  std::fprintf(stderr, "%s: %.1f million cycles simulated\n", name_.c_str(), double(cycle_) * 1e-6);
}

bool Bench::run(const std::function<bool()>& done, std::uint64_t patience) {
  std::uint64_t waited = 0;
  const std::uint64_t from = cycle_, moved_before = moves_;
  while (!done()) {
    waited = step() ? 0 : waited + 1;
    if (cycle_ % 65536 == 0) tell_progress();
    if (options_->mutant != 0 && is_wrong()) return false;  // found: what follows tells no more
    if (cycle_ - from > 10 * patience + kCyclesAWord * (moves_ - moved_before)) {
      failures_.push_back("too slow: " + std::to_string(moves_) + " cycles of " + std::to_string(cycle_) +
                          " moved a word; " + waiting());
      return false;
    }
    if (waited <= patience) continue;
    failures_.push_back("hang: no word moved for " + std::to_string(patience) + " cycles; " + waiting());
    return false;
  }
  return true;
}

bool Bench::is_wrong() const {
  return !failures_.empty() || std::any_of(receivers_.begin(), receivers_.end(),
                                           [](const Receiver& receiver) { return receiver.mismatches() != 0; });
}

bool Bench::all_done() const {
  for (const Sender& sender : senders_) {
    if (!sender.done()) return false;
  }
  for (const Receiver& receiver : receivers_) {
    if (!receiver.done()) return false;
  }
  return true;
}

bool Bench::all_taken() const {
  return std::all_of(senders_.begin(), senders_.end(), [](const Sender& sender) { return sender.done(); });
}

std::uint64_t Bench::late() const {
  return std::accumulate(senders_.begin(), senders_.end(), std::uint64_t(0),
                         [](std::uint64_t sum, const Sender& sender) { return sum + sender.late(); });
}

bool Bench::done(std::size_t frames) const {
  const auto is_through = [&](const auto& end) { return end.done() || end.segments_done() >= frames; };
  return std::all_of(senders_.begin(), senders_.end(), is_through) &&
         std::all_of(receivers_.begin(), receivers_.end(), is_through);
}

std::string Bench::waiting() const {
  std::string text;
  const auto add = [&](const std::string& state) { text += (text.empty() ? "waiting: " : ", ") + state; };
  for (const Sender& sender : senders_) {
    if (!sender.done()) add(sender.state());
  }
  for (const Receiver& receiver : receivers_) {
    if (!receiver.done()) add(receiver.state());
  }
  return text.empty() ? "all words were seen, and the model is still busy" : text;
}

void Bench::fail(const std::string& what) {
  const auto same = [&](const std::string& told) { return told.rfind(what, 0) == 0; };
  if (std::none_of(failures_.begin(), failures_.end(), same))
    failures_.push_back(what + ", cycle " + std::to_string(cycle_));
}

void Bench::idle(int cycles) {
  for (int i = 0; i < cycles; ++i) step();
}

namespace {

StreamState state_of(const Wires& wires) {
  return {*wires.valid->bit() != 0, wires.ready == nullptr || *wires.ready->bit() != 0};
}

}  // namespace

// Of the lives of the model the first one that fails is told.
void Bench::note_cycle(const Receiver& receiver, Result* result) const {
  const std::int64_t first = receiver.first_cycle();
  if (first < 0 || (result->first_life != 0 && result->first_life != life_)) return;
  if (result->first_life == life_ && first >= result->first_cycle) return;
  result->first_cycle = first;
  result->first_life = life_;
  result->first_model = model_->number();
}

void Bench::note_life(Result* result) const {
  if (result->first_life != 0 || result->passed()) return;
  if (result->first_cycle < 0) result->first_cycle = std::int64_t(last_move_);
  result->first_life = life_;
  result->first_model = model_->number();
}

void Bench::abandon(const std::string& note, Result* result) {
  for (const Receiver& receiver : receivers_) {
    for (const std::string& failure : receiver.failures()) result->failures.push_back(failure + note);
    note_cycle(receiver, result);
    if (receiver.mismatches() == 0) continue;
    const Stream& stream = *vectors_->find(receiver.name());
    result->streams.push_back(
        {stream.name, stream.from, stream.to, receiver.words(), receiver.mismatches(), 0, {}, {}});
  }
  for (const std::string& failure : failures_) result->failures.push_back(failure + note);
  result->simulated += cycle_;
  note_life(result);
}

// What a model with index_pool says at its end of triangles that found no index, against the indices of the set.
void Bench::check_none_left() {
  const Port* const port = model_->find(kNoneLeft);
  if (!port || !model_->constant("GivesIndices")) return;
  const Stream* const given = vectors_->find(vectors_->find("numbered") ? "numbered" : "visible");
  const Field& index = given->need("index", "the bench of index_pool");
  bool expected = false;
  for (std::size_t n = 0; n < given->words.size(); ++n) expected = expected || index.raw(given->words[n]) == 0;
  if ((*port->bit() != 0) == expected) return;
  failures_.push_back(std::string(kNoneLeft) + " is " + (expected ? "0, and a triangle" : "1, and no triangle") +
                      " of the set is without an index");
}

void Bench::finish(Result* result) {
  check_none_left();
  for (Receiver& receiver : receivers_) {
    receiver.finish();
    const Stream& stream = *vectors_->find(receiver.name());
    result->streams.push_back({stream.name, stream.from, stream.to, receiver.words(), receiver.mismatches(),
                               receiver.missing(), receiver.failures(), receiver.wrong()});
    result->ends[stream.name] = state_of(receiver.wires());
    note_cycle(receiver, result);
    if (receiver.words() == 0 && !vectors_->is_background()) {
      failures_.push_back("empty: no word of " + describe_stream(stream) +
                          " was compared; use a vector set that has some");
    }
  }
  for (const Sender& sender : senders_) result->ends[sender.name()] = state_of(sender.wires());
  blame(*vectors_, result);
  for (const std::string& failure : failures_) result->failures.push_back(failure);
  result->simulated += cycle_;
  result->timeline = timeline_;
  note_life(result);
}

}  // namespace halfspace::tb
