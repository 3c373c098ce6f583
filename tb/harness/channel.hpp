// SPDX-License-Identifier: Apache-2.0
// The two ends of a stream at a model: Sender offers words of a vector file, Receiver takes or watches words and
// holds each whole word against the file.
//
// A clock cycle is: drive() of all, evaluate with the clock low, sample() of all, evaluate with the clock high.
#ifndef HALFSPACE_TB_HARNESS_CHANNEL_HPP_
#define HALFSPACE_TB_HARNESS_CHANNEL_HPP_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/harness/model.hpp"
#include "tb/harness/stall.hpp"
#include "tb/harness/vectors.hpp"
#include "tb/report/describe.hpp"

namespace halfspace::tb {

// The words [begin, end) of a stream, all of one frame.
struct Segment {
  const Stream* stream;
  std::size_t begin, end;
  std::size_t frame;
  std::string note;
};
Segment segment_of(const Stream& stream, std::size_t frame, const std::string& note = "");
// Whether a stream has the same words in two frames.
bool same_words(const Stream& stream, std::size_t a, std::size_t b);

// The wires of a stream whose ports are <port>_i, <port>_valid_i and so on. Null where the model has none.
struct Wires {
  const Port* data = nullptr;
  const Port* valid = nullptr;
  const Port* ready = nullptr;
};
Wires input_wires(const Model& model, const std::string& port, const Stream& stream);
Wires output_wires(const Model& model, const std::string& port, const Stream& stream);

// A word that is not as expected.
struct WrongWord {
  std::size_t word;  // of the stream's file
  std::uint64_t cycle;
  std::vector<std::uint32_t> got;
};

class Sender {
 public:
  // Without a ready port every word offered is taken.
  Sender(const Wires& wires, std::string name, std::uint64_t seed, int stall_percent);

  void send(Segment segment);
  // From now on no word is offered that is not among the first `allowed`, which may grow.
  void hold(const std::size_t* allowed) { allowed_ = allowed; }
  void drive();
  // Whether a word moved.
  bool sample();
  bool done() const { return current_ == segments_.size(); }
  // Whether it has a word and does not offer it in this cycle.
  bool stalls() const { return !done() && !offering_; }
  // Words that were not offered at once.
  std::uint64_t late() const { return late_; }
  std::size_t segments_done() const { return current_; }
  // "triangle: 12 of 40 words taken, valid 1, ready 0"
  std::string state() const;
  std::size_t words() const { return words_; }
  const std::string& name() const { return name_; }
  const Wires& wires() const { return wires_; }

 private:
  void skip_empty();
  void offer();
  void withdraw();
  void complement();
  // Each byte of the port that is driven.
  template <class Changed>
  void change(Changed changed);

  Wires wires_;
  std::string name_;
  Stall stall_;
  Random early_;
  std::vector<Segment> segments_;
  std::size_t current_ = 0, position_ = 0, words_ = 0, total_ = 0;
  std::uint64_t late_ = 0;
  bool offering_ = false, is_late_ = false;
  const std::size_t* allowed_ = nullptr;
};

class Receiver {
 public:
  // A ready port that is an input of the model is driven; one that is an output is watched. Without one every word
  // that is valid counts.
  Receiver(const Wires& wires, const Vectors& vectors, std::string name, std::uint64_t seed, int stall_percent);

  void expect(Segment segment);
  // Keeps what is really received of a segment, until the next one begins: at the end, of the last that came.
  void record_last(Words* sink) { sink_ = sink; }
  // Tells each word that is really received, right or wrong.
  void on_word(std::function<void(const std::uint32_t*)> listener) { listener_ = std::move(listener); }
  void drive();
  // Whether a word moved that was expected: a unit that sends without an end does not get on.
  bool sample(std::uint64_t cycle);
  bool done() const { return current_ == segments_.size(); }
  // Whether a word is offered and not taken in this cycle.
  bool stalls() const { return drives_ready_ && *wires_.valid->bit() != 0 && *wires_.ready->bit() == 0; }
  std::size_t segments_done() const { return current_; }
  std::string state() const;
  // Counts the words that never came.
  void finish();

  const std::string& name() const { return name_; }
  std::size_t words() const { return words_; }
  std::size_t mismatches() const { return mismatches_ + surplus_ + protocol_; }
  std::size_t missing() const { return missing_; }
  // The cycle of the first failure that is no missing word; < 0: there is none.
  std::int64_t first_cycle() const { return first_cycle_; }
  const Wires& wires() const { return wires_; }
  // The first of them.
  const std::vector<WrongWord>& wrong() const { return wrong_; }
  // Sentences: the first mismatch, the first word of surplus, what is missing, the first fault of the handshake.
  const std::vector<std::string>& failures() const { return failures_; }
  // The cycle of each frame's last word, in the order of the segments.
  const std::vector<std::uint64_t>& end_cycles() const { return end_cycles_; }

 private:
  void skip_empty(std::uint64_t cycle);
  void check_held(bool valid, std::uint64_t cycle);
  bool take(std::uint64_t cycle);
  void take_surplus(std::uint64_t cycle);
  void fail(const std::string& sentence, std::uint64_t cycle);

  Wires wires_;
  bool drives_ready_;
  const Vectors& vectors_;
  std::string name_;
  Stall stall_;
  std::vector<Segment> segments_;
  std::size_t current_ = 0, position_ = 0;
  std::size_t words_ = 0, total_ = 0, mismatches_ = 0, surplus_ = 0, missing_ = 0, protocol_ = 0;
  std::vector<std::string> failures_;
  std::int64_t first_cycle_ = -1;
  std::vector<WrongWord> wrong_;
  std::vector<std::uint64_t> end_cycles_;
  std::vector<std::uint32_t> held_;
  bool is_held_ = false, shy_ = false;
  Words* sink_ = nullptr;
  std::function<void(const std::uint32_t*)> listener_;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_CHANNEL_HPP_
