// SPDX-License-Identifier: Apache-2.0
// A record as the word that has it in vectors and in the RTL: the fields that visit() names, the first in the most
// significant place; lane 0 of a field that comes once a lane in the least.
//
//   PackedBits<R>::kBits   the width of a word of record R
//   Packed<R>              that word
//   packed(record), unpacked<R>(word)
#ifndef HALFSPACE_HLS_NUMBERS_PACKED_HPP_
#define HALFSPACE_HLS_NUMBERS_PACKED_HPP_

#include <cstddef>

#include "hls/numbers/fixed.hpp"
#include "hls/numbers/pragmas.hpp"
#include "hls/numbers/word.hpp"

namespace halfspace {

namespace packed_detail {

struct BitCounter {
  int count;

  template <class T>
  constexpr void operator()(const char*, const T&) {
    count += T::kWidth;
  }
  template <class T, std::size_t N>
  constexpr void lanes(const char*, const T (&)[N]) {
    count += T::kWidth * int(N);
  }
};

template <class Record>
constexpr int bit_count() {
  Record record{};
  BitCounter counter{0};
  record.visit(counter);
  return counter.count;
}

template <int W>
class Unpacker {
 public:
  Unpacker(const Word<W>& word, int bits) : word_(word), at_(bits) {}
  template <class T>
  HS_INLINE void operator()(const char*, T& value) {
    at_ -= T::kWidth;
    value = from_raw<T>(bits<T::kWidth>(word_, at_));
  }
  template <class T, std::size_t N>
  HS_INLINE void lanes(const char* name, T (&values)[N]) {
  Lanes:
    for (std::size_t l = N; l > 0; --l) {
      HS_UNROLL
      operator()(name, values[l - 1]);
    }
  }

 private:
  const Word<W>& word_;
  int at_;
};

template <int W>
class Packer {
 public:
  Packer(Word<W>& word, int bits) : word_(word), at_(bits) {}
  template <class T>
  HS_INLINE void operator()(const char*, const T& value) {
    at_ -= T::kWidth;
    set_bits<T::kWidth>(word_, at_, std::uint64_t(raw(value)));
  }
  template <class T, std::size_t N>
  HS_INLINE void lanes(const char* name, const T (&values)[N]) {
  Lanes:
    for (std::size_t l = N; l > 0; --l) {
      HS_UNROLL
      operator()(name, values[l - 1]);
    }
  }

 private:
  Word<W>& word_;
  int at_;
};

}  // namespace packed_detail

// Of a record on formats F, which need not be made of numbers of C++.
template <class Record>
struct PackedBits;
template <template <class> class R, class F>
struct PackedBits<R<F>> {
  static constexpr int kBits = packed_detail::bit_count<R<typename F::Constexpr>>();
  static constexpr int kWordBits = word_bits(kBits);
};

template <template <class, int> class R, class F, int N>
struct PackedBits<R<F, N>> {
  static constexpr int kBits = packed_detail::bit_count<R<typename F::Constexpr, N>>();
  static constexpr int kWordBits = word_bits(kBits);
};

template <class Record>
using Packed = Word<PackedBits<Record>::kWordBits>;

template <class Record>
HS_INLINE inline Packed<Record> packed(const Record& record) {
  Packed<Record> word = zero_word<PackedBits<Record>::kWordBits>();
  packed_detail::Packer<PackedBits<Record>::kWordBits> packer(word, PackedBits<Record>::kBits);
  // visit() is not const, as an unpacker writes. A copy would be a function of its own to Bambu, and a memory.
  const_cast<Record&>(record).visit(packer);
  return word;
}

template <class Record>
HS_INLINE inline Record unpacked(const Packed<Record>& word) {
  Record record{};
  packed_detail::Unpacker<PackedBits<Record>::kWordBits> unpacker(word, PackedBits<Record>::kBits);
  record.visit(unpacker);
  return record;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_PACKED_HPP_
