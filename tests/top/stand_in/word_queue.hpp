// SPDX-License-Identifier: Apache-2.0
// What hls_stream.h and ac_channel.h of this folder are made of: a queue without an end, as both are where a tool runs
// the C++. Reading an empty one ends the program: the hardware would wait for ever. The libraries themselves warn, or
// assert.
#ifndef HALFSPACE_TESTS_TOP_STAND_IN_WORD_QUEUE_HPP_
#define HALFSPACE_TESTS_TOP_STAND_IN_WORD_QUEUE_HPP_

#include <cstdio>
#include <cstdlib>
#include <deque>

namespace stand_in {

template <class T>
class WordQueue {
 public:
  std::size_t size() const { return words_.size(); }
  void push(const T& word) { words_.push_back(word); }
  T pop() {
    if (words_.empty()) {
      std::fputs("a top reads from an empty channel: in hardware it would wait for ever\n", stderr);
      std::exit(1);
    }
    const T word = words_.front();
    words_.pop_front();
    return word;
  }

 private:
  std::deque<T> words_;
};

}  // namespace stand_in

#endif  // HALFSPACE_TESTS_TOP_STAND_IN_WORD_QUEUE_HPP_
