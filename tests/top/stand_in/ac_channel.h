// SPDX-License-Identifier: Apache-2.0
// In the place of Siemens' ac_channel.h ("Algorithmic C Datatypes", chapter on channels). available(n) tells a bench
// whether there are n words; in hardware it is always true.
#ifndef HALFSPACE_TESTS_TOP_STAND_IN_AC_CHANNEL_H_
#define HALFSPACE_TESTS_TOP_STAND_IN_AC_CHANNEL_H_

#include "tests/top/stand_in/word_queue.hpp"

template <class T>
class ac_channel {
 public:
  ac_channel() {}
  ac_channel(const ac_channel&) = delete;
  ac_channel& operator=(const ac_channel&) = delete;

  bool available(unsigned count) const { return words_.size() >= count; }
  unsigned size() const { return unsigned(words_.size()); }
  void write(const T& word) { words_.push(word); }
  T read() { return words_.pop(); }

 private:
  stand_in::WordQueue<T> words_;
};

#endif  // HALFSPACE_TESTS_TOP_STAND_IN_AC_CHANNEL_H_
