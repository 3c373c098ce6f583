// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/channel.hpp"

#include <cstring>

namespace halfspace::tb {
namespace {

constexpr std::size_t kWrongKept = 100;

std::string count_of(std::size_t n, std::size_t total) { return std::to_string(n) + " of " + std::to_string(total); }

std::string handshake(const Wires& wires) {
  std::string text = ", valid " + std::to_string(*wires.valid->bit());
  if (wires.ready) text += ", ready " + std::to_string(*wires.ready->bit());
  return text;
}

// A port's value as a word of its stream.
std::vector<std::uint32_t> word_at(const Port& port, std::size_t parts) {
  std::vector<std::uint32_t> word(parts, 0);
  std::memcpy(word.data(), port.data, std::size_t(port.bytes));
  return word;
}

}  // namespace

Segment segment_of(const Stream& stream, std::size_t frame, const std::string& note) {
  std::size_t begin = 0;
  for (std::size_t f = 0; f < frame; ++f) begin += stream.frame_words[f];
  return {&stream, begin, begin + stream.frame_words[frame], frame, note};
}

bool same_words(const Stream& stream, std::size_t a, std::size_t b) {
  const Segment first = segment_of(stream, a), second = segment_of(stream, b);
  if (first.end - first.begin != second.end - second.begin) return false;
  for (std::size_t n = 0; n < first.end - first.begin; ++n) {
    if (std::memcmp(stream.words[first.begin + n], stream.words[second.begin + n], stream.words.parts() * 4) != 0)
      return false;
  }
  return true;
}

Wires input_wires(const Model& model, const std::string& port, const Stream& stream) {
  return {&model.need(port + "_i", stream.bits), &model.need(port + "_valid_i", 1), model.find(port + "_ready_o")};
}

Wires output_wires(const Model& model, const std::string& port, const Stream& stream) {
  const Port* ready = model.find(port + "_ready_i");
  if (ready == nullptr) ready = model.find(port + "_ready_o");
  return {&model.need(port + "_o", stream.bits), &model.need(port + "_valid_o", 1), ready};
}

Sender::Sender(const Wires& wires, std::string name, std::uint64_t seed, int stall_percent)
    : wires_(wires), name_(std::move(name)), stall_(seed, stall_percent), early_(~seed) {
  *wires_.valid->bit() = 0;
  complement();
}

void Sender::send(Segment segment) {
  total_ += segment.end - segment.begin;
  const bool was_done = done();
  segments_.push_back(std::move(segment));
  if (was_done) position_ = segments_[current_].begin;
  skip_empty();
}

void Sender::skip_empty() {
  while (!done() && position_ == segments_[current_].end) {
    if (++current_ < segments_.size()) position_ = segments_[current_].begin;
  }
}

void Sender::drive() {
  if (offering_) return;
  const bool held = allowed_ && words_ >= *allowed_, was_late = is_late_;
  if (!done() && !held && !stall_.next()) {
    offer();
    is_late_ = false;
    return;
  }
  is_late_ = !done();
  late_ += is_late_ && !was_late;
  if (*wires_.valid->bit() != 0) withdraw();
}

void Sender::offer() {
  offering_ = true;
  *wires_.valid->bit() = 1;
  std::memcpy(wires_.data->data, segments_[current_].stream->words[position_], std::size_t(wires_.data->bytes));
}

template <class Changed>
void Sender::change(Changed changed) {
  auto* const bytes = static_cast<std::uint8_t*>(wires_.data->data);
  for (int i = 0; i < wires_.data->bytes; ++i) {
    const int used = wires_.data->bits - 8 * i;
    const std::uint8_t byte = changed(bytes[i]);
    bytes[i] = used >= 8 ? byte : used > 0 ? std::uint8_t(byte & ((1 << used) - 1)) : 0;
  }
}

// The data of no word, so that a unit that looks at it without valid gives itself away: the next one too early, the
// complement of the last, or the last with a bit changed in half of its bytes, so that fields that choose what it is
// for may stay and others do not.
void Sender::withdraw() {
  *wires_.valid->bit() = 0;
  const std::uint64_t kind = early_.next() % 4;
  if (!done() && kind < 2) {
    std::memcpy(wires_.data->data, segments_[current_].stream->words[position_], std::size_t(wires_.data->bytes));
  } else if (kind == 2) {
    complement();
  } else {
    change([&](std::uint8_t byte) {
      const std::uint64_t draw = early_.next();
      return std::uint8_t(byte ^ ((draw & 8) != 0 ? 1 << (draw & 7) : 0));
    });
  }
}

void Sender::complement() {
  change([](std::uint8_t byte) { return std::uint8_t(~byte); });
}

bool Sender::sample() {
  if (!offering_ || (wires_.ready && *wires_.ready->bit() == 0)) return false;
  offering_ = false;
  ++words_;
  ++position_;
  skip_empty();
  return true;
}

std::string Sender::state() const {
  return name_ + " (" + count_of(words_, total_) + " words taken" + handshake(wires_) + ")";
}

Receiver::Receiver(const Wires& wires, const Vectors& vectors, std::string name, std::uint64_t seed, int stall_percent)
    : wires_(wires),
      drives_ready_(wires.ready != nullptr && wires.ready->input),
      vectors_(vectors),
      name_(std::move(name)),
      stall_(seed, stall_percent) {
  if (drives_ready_) *wires_.ready->bit() = 0;
}

void Receiver::expect(Segment segment) {
  total_ += segment.end - segment.begin;
  held_.resize(segment.stream->words.parts());
  const bool was_done = done();
  segments_.push_back(std::move(segment));
  if (was_done) position_ = segments_[current_].begin;
  skip_empty(0);
}

void Receiver::skip_empty(std::uint64_t cycle) {
  while (!done() && position_ == segments_[current_].end) {
    end_cycles_.push_back(cycle);
    if (++current_ == segments_.size()) continue;
    position_ = segments_[current_].begin;
    if (sink_) sink_->clear();
  }
}

void Receiver::drive() {
  if (!drives_ready_) return;
  const bool stalls = stall_.next();
  shy_ = shy_ || stall_.shy();
  // A shy receiver raises ready once it saw valid, in the cycle before; so it never looks at this cycle's valid.
  *wires_.ready->bit() = !stalls && (!shy_ || is_held_);
}

bool Receiver::sample(std::uint64_t cycle) {
  const bool valid = *wires_.valid->bit() != 0;
  if (is_held_) check_held(valid, cycle);
  if (!valid) return false;
  if (wires_.ready == nullptr || *wires_.ready->bit() != 0) {
    is_held_ = false;
    // A phase of shyness lasts until a word moved in it: a unit that waits for ready is then seen to hang.
    shy_ = shy_ && stall_.shy();
    return take(cycle);
  }
  if (!is_held_ && !held_.empty()) {
    is_held_ = true;
    std::memcpy(held_.data(), wires_.data->data, std::size_t(wires_.data->bytes));
  }
  return false;
}

// A word that was offered and not taken is still offered, unchanged.
void Receiver::check_held(bool valid, std::uint64_t cycle) {
  if (valid && std::memcmp(held_.data(), wires_.data->data, std::size_t(wires_.data->bytes)) == 0) return;
  is_held_ = false;
  if (protocol_++ != 0) return;
  const Stream& stream = *segments_.back().stream;
  std::string what = "protocol: " + describe_stream(stream) + " ";
  if (!valid) {
    what += "dropped valid before ready";
  } else {
    what += "changed its word while valid and not ready";
  }
  what += " after " + std::to_string(words_) + " words, cycle " + std::to_string(cycle) +
          "; held: " + describe_fields(stream, held_.data());
  if (valid) what += "; now: " + describe_fields(stream, word_at(*wires_.data, held_.size()).data());
  fail(what, cycle);
}

void Receiver::fail(const std::string& sentence, std::uint64_t cycle) {
  failures_.push_back(sentence);
  if (first_cycle_ < 0) first_cycle_ = std::int64_t(cycle);
}

bool Receiver::take(std::uint64_t cycle) {
  if (sink_) std::memcpy(sink_->append(), wires_.data->data, std::size_t(wires_.data->bytes));
  if (listener_) listener_(word_at(*wires_.data, held_.size()).data());
  if (done()) {
    take_surplus(cycle);
    return false;
  }
  const Segment& segment = segments_[current_];
  ++words_;
  if (std::memcmp(segment.stream->words[position_], wires_.data->data, std::size_t(wires_.data->bytes)) != 0) {
    if (wrong_.size() < kWrongKept) wrong_.push_back({position_, cycle, word_at(*wires_.data, held_.size())});
    if (mismatches_++ == 0) {
      const WordPlace place{&vectors_, segment.stream, position_, segment.frame, segment.note, std::int64_t(cycle)};
      fail(describe_mismatch(place, word_at(*wires_.data, held_.size()).data()), cycle);
    }
  }
  ++position_;
  skip_empty(cycle);
  return true;
}

void Receiver::take_surplus(std::uint64_t cycle) {
  if (surplus_++ != 0) return;
  std::string what = "surplus: " + name_ + " sends a word when none is expected";
  if (!segments_.empty()) {
    const Segment& last = segments_.back();
    what = "surplus: " + describe_stream(*last.stream) + " sends a word more than the " +
           std::to_string(last.end - last.begin) + " of frame " + std::to_string(last.frame) + last.note + ", cycle " +
           std::to_string(cycle) + ": " + describe_fields(*last.stream, word_at(*wires_.data, held_.size()).data());
  }
  fail(what, cycle);
}

void Receiver::finish() {
  if (done()) return;
  missing_ = total_ - words_;
  const Segment& segment = segments_[current_];
  failures_.push_back("missing: " + std::to_string(missing_) + " of " + std::to_string(total_) + " words on " +
                      describe_stream(*segment.stream) + ", from word " + std::to_string(position_) + ", frame " +
                      std::to_string(segment.frame) + segment.note + ", on");
}

std::string Receiver::state() const {
  return name_ + " (" + count_of(words_, total_) + " words seen" + handshake(wires_) + ")";
}

}  // namespace halfspace::tb
