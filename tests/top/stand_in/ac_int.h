// SPDX-License-Identifier: Apache-2.0
// In the place of Siemens' ac_int.h ("Algorithmic C Datatypes", section on slices): slc<N>(lsb) is N bits from place
// lsb on, set_slc(lsb, x) puts x there, whose width says how many.
#ifndef HALFSPACE_TESTS_TOP_STAND_IN_AC_INT_H_
#define HALFSPACE_TESTS_TOP_STAND_IN_AC_INT_H_

#include "tests/top/stand_in/word_bits.hpp"

template <int W, bool Signed>
class ac_int {
  static_assert(!Signed, "words are unsigned");

 public:
  ac_int() {}
  ac_int(std::uint64_t value) : bits_(value) {}

  template <int N>
  ac_int<N, Signed> slc(int lsb) const {
    return bits_.get(lsb, N);
  }
  template <int N, bool OfSigned>
  ac_int& set_slc(int lsb, const ac_int<N, OfSigned>& slice) {
    bits_.set(lsb, N, slice.to_uint64());
    return *this;
  }
  bool operator==(const ac_int& other) const { return bits_ == other.bits_; }
  // The 64 lowest bits.
  std::uint64_t to_uint64() const { return bits_.get(0, W < 64 ? W : 64); }

 private:
  stand_in::WordBits<W> bits_;
};

#endif  // HALFSPACE_TESTS_TOP_STAND_IN_AC_INT_H_
