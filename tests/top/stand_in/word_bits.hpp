// SPDX-License-Identifier: Apache-2.0
// What ap_int.h and ac_int.h of this folder are made of. The folder stands in for headers of tools, for tests where no
// tool is: of each what hls/numbers uses, as the manuals have it, and nothing else.
#ifndef HALFSPACE_TESTS_TOP_STAND_IN_WORD_BITS_HPP_
#define HALFSPACE_TESTS_TOP_STAND_IN_WORD_BITS_HPP_

#include <cassert>
#include <cstdint>

namespace stand_in {

// W bits.
template <int W>
struct WordBits {
  static_assert(W > 0, "a word has bits");

  // A word has no value before it is given one, unless it is static, and so zero. Whoever takes a variable of a
  // function for zero has this instead.
  WordBits() {
    if (!on_stack()) return;
    for (std::uint64_t& of : element) of = 0x9249249249249249;
  }
  explicit WordBits(std::uint64_t value) : element{} {
    for (int i = 0; i < W; ++i) set(i, 1, i < 64 ? value >> i : 0);
  }

  // `count` bits from place `lsb` on, all of them of the word, and 64 at most.
  std::uint64_t get(int lsb, int count) const {
    check(lsb, count);
    std::uint64_t value = 0;
    for (int i = count; i-- > 0;) value = value << 1 | (element[(lsb + i) / 64] >> (lsb + i) % 64 & 1);
    return value;
  }
  void set(int lsb, int count, std::uint64_t value) {
    check(lsb, count);
    for (int i = 0; i < count; ++i) {
      std::uint64_t& of = element[(lsb + i) / 64];
      const int place = (lsb + i) % 64;
      of = (of & ~(std::uint64_t(1) << place)) | (value >> i & 1) << place;
    }
  }
  bool operator==(const WordBits& other) const {
    for (int i = 0; i < W; ++i) {
      if (get(i, 1) != other.get(i, 1)) return false;
    }
    return true;
  }

 private:
  // Near a variable of this function.
  bool on_stack() const {
    const char here = 0;
    const auto a = reinterpret_cast<std::uintptr_t>(this), b = reinterpret_cast<std::uintptr_t>(&here);
    return (a > b ? a - b : b - a) < (std::uintptr_t(1) << 20);
  }
  static void check(int lsb, int count) {
    (void)lsb, (void)count;
    assert(lsb >= 0 && count > 0 && count <= 64 && lsb + count <= W && "bits that the word has not");
  }

  std::uint64_t element[(W + 63) / 64];
};

}  // namespace stand_in

#endif  // HALFSPACE_TESTS_TOP_STAND_IN_WORD_BITS_HPP_
