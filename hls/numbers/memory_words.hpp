// SPDX-License-Identifier: Apache-2.0
// A memory beside a top: an array of words, each that of a record as in vectors. Words<R> is the view of it that a
// kernel has, which reads and writes it as an array of records.
#ifndef HALFSPACE_HLS_NUMBERS_MEMORY_WORDS_HPP_
#define HALFSPACE_HLS_NUMBERS_MEMORY_WORDS_HPP_

#include "hls/numbers/packed.hpp"

namespace halfspace {

template <class R>
class Words {
 public:
  // A word of it, which is read or written whole.
  class Reference {
   public:
    HS_INLINE explicit Reference(Packed<R>& word) : word_(word) {}
    HS_INLINE operator R() const { return unpacked<R>(word_); }
    HS_INLINE Reference& operator=(const R& record) {
      word_ = packed(record);
      return *this;
    }
    template <class Row = R>
    HS_INLINE typename Row::Lane operator[](int lane) const {
      return unpacked<Row>(word_)[lane];
    }

   private:
    Packed<R>& word_;
  };

  Words() : words_(nullptr) {}  // that the configuration has no use for
  explicit Words(Packed<R>* words) : words_(words) {}
  HS_INLINE R operator[](int address) const { return unpacked<R>(words_[address]); }
  HS_INLINE Reference operator[](int address) { return Reference(words_[address]); }

 private:
  Packed<R>* words_;
};

// Rows of N words.
template <class R, int N>
class WordRows {
 public:
  WordRows() : words_(nullptr) {}
  explicit WordRows(Packed<R>* words) : words_(words) {}
  HS_INLINE const Words<R> operator[](int row) const { return Words<R>(words_ + row * N); }
  HS_INLINE Words<R> operator[](int row) { return Words<R>(words_ + row * N); }

 private:
  Packed<R>* words_;
};

// memory[address] = lanes, of a record that is these.
template <class R, class T, std::size_t N>
HS_INLINE inline void store_lanes(Words<R>& memory, int address, const T (&lanes)[N]) {
  R word;
Lanes:
  for (std::size_t l = 0; l < N; ++l) {
    HS_UNROLL
    word.lane[l] = lanes[l];
  }
  memory[address] = word;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_MEMORY_WORDS_HPP_
