// SPDX-License-Identifier: Apache-2.0
// A word of W bits, as a port or a memory has: bits, and no number. Natively of elements of 64 bits; a synthesis tool
// has its own.
//
//   bits<N>(word, lsb)             N of its bits, from place `lsb` on; N is 1 … 64
//   set_bits<N>(word, lsb, value)  the inverse, of the N lowest bits of `value`
//   word_bits(n)                   the width of a word for n bits: what is above them is 0
//   zero_word<W>()                 of zeros: a tool's own has no value before it is given one
#ifndef HALFSPACE_HLS_NUMBERS_WORD_HPP_
#define HALFSPACE_HLS_NUMBERS_WORD_HPP_

#include <cstdint>

#include "hls/numbers/pragmas.hpp"

#if defined(HALFSPACE_STREAM_AC)
#include <ac_int.h>
namespace halfspace {
// Of 64 bits an integer: Bambu keeps an object that goes through a channel in a memory, and an integer in a register.
namespace word_detail {
template <int W>
struct WordOf {
  using Type = ac_int<W, false>;
};
template <>
struct WordOf<64> {
  using Type = std::uint64_t;
};
}  // namespace word_detail
template <int W>
using Word = typename word_detail::WordOf<W>::Type;
// Whole elements of an ac_int as Bambu has it: its co-simulations compare words as memory.
constexpr int word_bits(int n) { return (n + 63) / 64 * 64; }
template <int N, int W>
HS_INLINE inline std::uint64_t bits(const ac_int<W, false>& word, int lsb) {
  return word.template slc<N>(lsb).to_uint64();
}
template <int N, int W>
HS_INLINE inline void set_bits(ac_int<W, false>& word, int lsb, std::uint64_t value) {
  word.set_slc(lsb, ac_int<N, false>(value));
}
template <int N>
HS_INLINE inline std::uint64_t bits(std::uint64_t word, int lsb) {
  return word >> lsb & ~std::uint64_t(0) >> (64 - N);
}
template <int N>
HS_INLINE inline void set_bits(std::uint64_t& word, int lsb, std::uint64_t value) {
  const std::uint64_t mask = ~std::uint64_t(0) >> (64 - N);
  word = (word & ~(mask << lsb)) | (value & mask) << lsb;
}
template <int W>
HS_INLINE inline Word<W> zero_word() {
  return Word<W>(0);
}
}  // namespace halfspace
#elif defined(HALFSPACE_STREAM_HLS) || defined(__VITIS_HLS__)
#include <ap_int.h>
namespace halfspace {
template <int W>
using Word = ap_uint<W>;
// Whole bytes, as an AXI4-Stream has them.
constexpr int word_bits(int n) { return (n + 7) / 8 * 8; }
template <int N, int W>
HS_INLINE inline std::uint64_t bits(const Word<W>& word, int lsb) {
  const ap_uint<N> field = word.range(lsb + N - 1, lsb);
  return field.to_uint64();
}
template <int N, int W>
HS_INLINE inline void set_bits(Word<W>& word, int lsb, std::uint64_t value) {
  word.range(lsb + N - 1, lsb) = ap_uint<N>(value);
}
template <int W>
HS_INLINE inline Word<W> zero_word() {
  return Word<W>(0);
}
}  // namespace halfspace
#else
namespace halfspace {
constexpr int word_bits(int n) { return n; }
template <int W>
struct Word {
  static constexpr int kElements = (W + 63) / 64;
  std::uint64_t element[kElements];

  Word() : element{} {}
  bool operator==(const Word& other) const {
    bool equal = true;
    for (int i = 0; i < kElements; ++i) equal = equal && element[i] == other.element[i];
    return equal;
  }
};
template <int W>
HS_INLINE inline Word<W> zero_word() {
  return Word<W>();
}

template <int N, int W>
HS_INLINE inline std::uint64_t bits(const Word<W>& word, int lsb) {
  const int first = lsb / 64, place = lsb % 64;
  std::uint64_t value = word.element[first] >> place;
  if (place + N > 64) value |= word.element[first + 1] << (64 - place);
  return N == 64 ? value : value & ((std::uint64_t(1) << N % 64) - 1);
}
template <int N, int W>
HS_INLINE inline void set_bits(Word<W>& word, int lsb, std::uint64_t value) {
  const int first = lsb / 64, place = lsb % 64;
  const std::uint64_t mask = N == 64 ? ~std::uint64_t(0) : (std::uint64_t(1) << N % 64) - 1;
  word.element[first] = (word.element[first] & ~(mask << place)) | (value & mask) << place;
  if (place + N > 64) {
    std::uint64_t& next = word.element[first + 1];
    next = (next & ~(mask >> (64 - place))) | (value & mask) >> (64 - place);
  }
}
}  // namespace halfspace
#endif

#endif  // HALFSPACE_HLS_NUMBERS_WORD_HPP_
