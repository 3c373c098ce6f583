// SPDX-License-Identifier: Apache-2.0
// Streams whose words are bits, as the ports of a top are: a Channel<R> has words of record R, packed as in vectors,
// and a Stream<R> is the view of it that a kernel has. stream.hpp includes this where a synthesis tool compiles, or
// what is for one.
#ifndef HALFSPACE_HLS_NUMBERS_STREAM_WORDS_HPP_
#define HALFSPACE_HLS_NUMBERS_STREAM_WORDS_HPP_

#include "hls/numbers/packed.hpp"

#if defined(HALFSPACE_STREAM_AC)
#include <ac_channel.h>
#define HS_CHANNEL ac_channel
#elif defined(HALFSPACE_STREAM_HLS) || defined(__VITIS_HLS__)
#include <hls_stream.h>
#define HS_CHANNEL hls::stream
#else
#include <cstddef>
#define HS_CHANNEL WordChannel
namespace halfspace {

// A queue without an end, of elements of 64 bits. Who links a top natively has it from stream_words.cpp, so that a top
// itself takes no memory.
class WordQueue {
 public:
  WordQueue();
  ~WordQueue();
  WordQueue(const WordQueue&) = delete;
  WordQueue& operator=(const WordQueue&) = delete;

  std::size_t size() const;  // elements
  void push(const std::uint64_t* elements, int count);
  // Of so many that are there, or the program ends with a word.
  void pop(std::uint64_t* elements, int count);

 private:
  struct Elements;
  Elements* elements_;
};

template <class W>
class WordChannel {
 public:
  bool empty() const { return queue_.size() == 0; }
  std::size_t size() const { return queue_.size() / W::kElements; }
  void write(const W& word) { queue_.push(word.element, W::kElements); }
  W read() {
    W word;
    queue_.pop(word.element, W::kElements);
    return word;
  }

 private:
  WordQueue queue_;
};

}  // namespace halfspace
#endif

namespace halfspace {

template <class Record>
using Channel = HS_CHANNEL<Packed<Record>>;

template <class Record>
class Stream {
 public:
  // Of a port that the configuration has no use for: nothing comes, and nothing goes.
  Stream() : words_(nullptr) {}
  explicit Stream(Channel<Record>& words) : words_(&words) {}
  HS_INLINE void write(const Record& record) { words_->write(packed(record)); }
  HS_INLINE Record read() { return unpacked<Record>(words_->read()); }

 private:
  Channel<Record>* words_;
};

template <class T>
struct Probe {
  void write(const T&) {}
};

}  // namespace halfspace
#undef HS_CHANNEL

#endif  // HALFSPACE_HLS_NUMBERS_STREAM_WORDS_HPP_
