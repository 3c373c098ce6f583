// SPDX-License-Identifier: Apache-2.0
// fixed.hpp on Siemens' ac_fixed.
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_AC_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_AC_HPP_

#include <ac_fixed.h>

#include "hls/numbers/fixed_library.hpp"

namespace halfspace {
namespace ac {

struct Library {
  template <int W, int I, bool S>
  using Number = ac_fixed<W, I, S, AC_TRN, AC_WRAP>;

  template <int W, int I, bool S>
  static std::uint64_t bits(const Number<W, I, S>& x) {
    return x.template slc<W>(0).to_uint64();
  }
  template <int W, int I, bool S>
  static void set_bits(Number<W, I, S>& x, fixed_detail::Carrier<W, S> bits) {
    x.set_slc(0, ac_int<W, S>(bits));
  }
  template <int W, int I, bool S, ac_q_mode Q, ac_o_mode O>
  static const ac_fixed<W, I, S, Q, O>& natural(const ac_fixed<W, I, S, Q, O>& result) {
    return result;
  }
};

template <int W, int I, bool S>
using Fixed = LibraryFixed<Library, W, I, S>;

}  // namespace ac
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_AC_HPP_
