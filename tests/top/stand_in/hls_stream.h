// SPDX-License-Identifier: Apache-2.0
// In the place of Xilinx's hls_stream.h (UG1399, "HLS Stream Library"). A stream is of one writer and one reader, and
// is handed on by reference; its depth is one of the hardware alone.
#ifndef HALFSPACE_TESTS_TOP_STAND_IN_HLS_STREAM_H_
#define HALFSPACE_TESTS_TOP_STAND_IN_HLS_STREAM_H_

#include "tests/top/stand_in/word_queue.hpp"

namespace hls {

template <class T, int Depth = 0>
class stream;

template <class T>
class stream<T, 0> {
 public:
  stream() {}
  explicit stream(const char* name) { (void)name; }
  stream(const stream&) = delete;
  stream& operator=(const stream&) = delete;

  bool empty() const { return words_.size() == 0; }
  std::size_t size() const { return words_.size(); }
  void write(const T& word) { words_.push(word); }
  T read() { return words_.pop(); }

 private:
  stand_in::WordQueue<T> words_;
};

template <class T, int Depth>
class stream : public stream<T, 0> {
 public:
  using stream<T, 0>::stream;
};

}  // namespace hls

#endif  // HALFSPACE_TESTS_TOP_STAND_IN_HLS_STREAM_H_
