// SPDX-License-Identifier: Apache-2.0
// fixed.hpp on Xilinx's ap_fixed and ap_ufixed.
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_AP_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_AP_HPP_

#include <ap_fixed.h>

#include "hls/numbers/fixed_library.hpp"

namespace halfspace {
namespace ap {

struct Library {
  template <int W, int I, bool S>
  using Number = typename std::conditional<S, ap_fixed<W, I, AP_TRN, AP_WRAP>, ap_ufixed<W, I, AP_TRN, AP_WRAP>>::type;

  template <int W, int I, bool S>
  static std::uint64_t bits(const Number<W, I, S>& x) {
    return x.range().to_uint64();
  }
  template <int W, int I, bool S>
  static void set_bits(Number<W, I, S>& x, fixed_detail::Carrier<W, S> bits) {
    x.range() = ap_uint<W>(bits);
  }
  template <int W, int I, bool S, ap_q_mode Q, ap_o_mode O, int N>
  static const ap_fixed_base<W, I, S, Q, O, N>& natural(const ap_fixed_base<W, I, S, Q, O, N>& result) {
    return result;
  }
};

template <int W, int I, bool S>
using Fixed = LibraryFixed<Library, W, I, S>;

}  // namespace ap
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_AP_HPP_
