// SPDX-License-Identifier: Apache-2.0
// Streams between kernels. Natively a stream is an unbounded queue of records. Where a top is compiled
// it is a view of a channel of words, and a synthesis tool has its own channels:
//
//   HALFSPACE_STREAM_HLS      hls::stream of Vitis HLS, which chooses this by itself
//   HALFSPACE_STREAM_AC       ac_channel
//   HALFSPACE_STREAM_WORDS    the tops natively: queues of words
//   HALFSPACE_STREAM_BOUNDED  of tests: queues of a bounded length, whose processes wait on threads of their own
#ifndef HALFSPACE_HLS_NUMBERS_STREAM_HPP_
#define HALFSPACE_HLS_NUMBERS_STREAM_HPP_

#include "hls/numbers/pragmas.hpp"

#ifdef HS_WORDS
#include "hls/numbers/stream_words.hpp"
#else
#include <cassert>
#include <cstddef>
#include <vector>

#ifdef HALFSPACE_STREAM_BOUNDED
#include "hls/numbers/stream_bounded.hpp"
#endif

namespace halfspace {

#ifndef HALFSPACE_STREAM_BOUNDED
// First in, first out. Reading an empty stream is an error of the caller: in hardware it would wait for ever.
template <class T>
class Stream {
 public:
  void write(const T& value) {
    queue_.push_back(value);
    if (tap_) tap_->push_back(value);
  }

  T read() {
    assert(!empty() && "read from an empty stream");
    T value = queue_[head_];
    if (++head_ == queue_.size()) {
      queue_.clear();
      head_ = 0;
    }
    return value;
  }

  bool empty() const { return head_ == queue_.size(); }

  // Simulation only: copies every later write to `sink` (null: to nowhere).
  void tap(std::vector<T>* sink) { tap_ = sink; }

 private:
  std::vector<T> queue_;
  std::size_t head_ = 0;
  std::vector<T>* tap_ = nullptr;
};
#endif

// A place to watch from, no wire of the circuit: what is written goes to the tap or nowhere.
template <class T>
class Probe {
 public:
  void write(const T& value) {
    if (tap_) tap_->push_back(value);
  }
  void tap(std::vector<T>* sink) { tap_ = sink; }

 private:
  std::vector<T>* tap_ = nullptr;
};

// What stands in a memory or a register before a frame: its words, for who watches.
template <class T>
struct Loaded {
  std::vector<T> words;
};

}  // namespace halfspace
#endif

namespace halfspace {

// Into a memory that takes a word at any time.
template <class T>
using Stored = Stream<T>;
// Between a unit and a memory outside, which natively it reaches by itself.
template <class T>
using Fetch = Probe<T>;

// A word to two readers.
template <class T>
void fork(Stream<T>& in, Stream<T>& first, Stream<T>& second) {
  const T word = in.read();
  first.write(word);
  second.write(word);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_STREAM_HPP_
