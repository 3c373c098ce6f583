// SPDX-License-Identifier: Apache-2.0
// In the place of Xilinx's ap_int.h (UG1399, "Arbitrary Precision Data Types Library"). range(hi, lo) is bits hi … lo,
// both of them included; a number can be made of it, and assigned to it.
#ifndef HALFSPACE_TESTS_TOP_STAND_IN_AP_INT_H_
#define HALFSPACE_TESTS_TOP_STAND_IN_AP_INT_H_

#include "tests/top/stand_in/word_bits.hpp"

template <int W>
class ap_uint;

template <int W>
class ap_range_ref {
 public:
  ap_range_ref(stand_in::WordBits<W>& word, int hi, int lo) : word_(word), hi_(hi), lo_(lo) {}
  template <int N>
  ap_range_ref& operator=(const ap_uint<N>& value) {
    word_.set(lo_, hi_ - lo_ + 1, value.to_uint64());
    return *this;
  }
  std::uint64_t to_uint64() const { return word_.get(lo_, hi_ - lo_ + 1); }

 private:
  stand_in::WordBits<W>& word_;
  int hi_, lo_;
};

template <int W>
class ap_uint {
 public:
  ap_uint() {}
  ap_uint(std::uint64_t value) : bits_(value) {}
  template <int N>
  ap_uint(const ap_range_ref<N>& range) : bits_(range.to_uint64()) {}

  ap_range_ref<W> range(int hi, int lo) { return {bits_, hi, lo}; }
  // As in the library, of a constant as well.
  ap_range_ref<W> range(int hi, int lo) const { return {const_cast<stand_in::WordBits<W>&>(bits_), hi, lo}; }
  bool operator==(const ap_uint& other) const { return bits_ == other.bits_; }
  // The 64 lowest bits.
  std::uint64_t to_uint64() const { return bits_.get(0, W < 64 ? W : 64); }

 private:
  stand_in::WordBits<W> bits_;
};

#endif  // HALFSPACE_TESTS_TOP_STAND_IN_AP_INT_H_
