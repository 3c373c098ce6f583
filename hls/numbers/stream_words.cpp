// SPDX-License-Identifier: Apache-2.0
#include "hls/numbers/stream_words.hpp"

#include <cstdio>
#include <cstdlib>
#include <deque>

namespace halfspace {

struct WordQueue::Elements {
  std::deque<std::uint64_t> queue;
};

WordQueue::WordQueue() : elements_(new Elements) {}
WordQueue::~WordQueue() { delete elements_; }

std::size_t WordQueue::size() const { return elements_->queue.size(); }

void WordQueue::push(const std::uint64_t* elements, int count) {
  elements_->queue.insert(elements_->queue.end(), elements, elements + count);
}

void WordQueue::pop(std::uint64_t* elements, int count) {
  for (int i = 0; i < count; ++i) {
    if (elements_->queue.empty()) {
      std::fputs("a top reads from an empty channel: in hardware it would wait for ever\n", stderr);
      std::exit(1);
    }
    elements[i] = elements_->queue.front();
    elements_->queue.pop_front();
  }
}

}  // namespace halfspace
