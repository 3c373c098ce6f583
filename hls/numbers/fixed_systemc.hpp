// SPDX-License-Identifier: Apache-2.0
// fixed.hpp on SystemC: sc_fixed and sc_ufixed. Its operators give an sc_fxval, exact and of no fixed width.
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_SYSTEMC_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_SYSTEMC_HPP_

#ifndef SC_INCLUDE_FX
#define SC_INCLUDE_FX  // or <systemc> leaves these types out
#endif
#include <systemc>

#include "hls/numbers/fixed_library.hpp"

namespace halfspace {
namespace systemc {

struct Library {
  template <int W, int I, bool S>
  using Number = typename std::conditional<S, sc_dt::sc_fixed<W, I, sc_dt::SC_TRN, sc_dt::SC_WRAP>,
                                           sc_dt::sc_ufixed<W, I, sc_dt::SC_TRN, sc_dt::SC_WRAP>>::type;

  // Not by to_int64() of the number scaled up, which SystemC 2.3.4 gives as 0 for multiples of 2^32.
  template <int W, int I, bool S>
  static std::uint64_t bits(const Number<W, I, S>& x) {
    return x.range().to_uint64();
  }
  template <int W, int I, bool S>
  static void set_bits(Number<W, I, S>& x, fixed_detail::Carrier<W, S> bits) {
    x = sc_dt::sc_fxval(bits) >> (W - I);
  }
  template <int W, int I, bool S>
  static const sc_dt::sc_fxval& natural(const sc_dt::sc_fxval& result) {
    return result;
  }
};

template <int W, int I, bool S>
using Fixed = LibraryFixed<Library, W, I, S>;

}  // namespace systemc
}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_SYSTEMC_HPP_
