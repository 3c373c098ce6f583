// SPDX-License-Identifier: Apache-2.0
// Fixed-point numbers: the only arithmetic that kernels see.
//
//   fix<W, I>, ufix<W, I>   W bits in all, I of them before the binary point; two's complement or unsigned.
//   raw(x)                  the bits as an integer; the value is raw(x) · 2^(I − W)
//   from_raw<T>(bits)       the inverse; bits beyond T's width are dropped
//   is_set(x)               whether a bit of x is: of a flag
//   + - * unary- compare    exact: the result is as wide as it has to be
//   T(x), T y = x           quantization: truncate toward minus infinity; overflow: wrap. The only modes there are:
//                           rounding is a half added beforehand, and no kernel saturates.
//   T()                     0; a T that is declared without a value has none yet
//
// No value is wider than 64 bits. The rules for the widths of results are those of ap_fixed and ac_fixed. A macro
// chooses what the numbers are, for all of a program; docs/types.md tells how to compile with each:
//
//   (none)                  integers of C++
//   HALFSPACE_TYPES_SYSTEMC sc_fixed, sc_ufixed of SystemC
//   HALFSPACE_TYPES_AP      ap_fixed, ap_ufixed of Xilinx
//   HALFSPACE_TYPES_AC      ac_fixed of Siemens
#ifndef HALFSPACE_HLS_NUMBERS_FIXED_HPP_
#define HALFSPACE_HLS_NUMBERS_FIXED_HPP_

#if defined(HALFSPACE_TYPES_SYSTEMC)
#include "hls/numbers/fixed_systemc.hpp"
namespace halfspace {
using systemc::Fixed;
}
#elif defined(HALFSPACE_TYPES_AP)
#include "hls/numbers/fixed_ap.hpp"
namespace halfspace {
using ap::Fixed;
}
#elif defined(HALFSPACE_TYPES_AC)
#include "hls/numbers/fixed_ac.hpp"
namespace halfspace {
using ac::Fixed;
}
#else
#include "hls/numbers/fixed_native.hpp"
namespace halfspace {
using native::Fixed;
}
#endif

namespace halfspace {

template <int W, int I>
using fix = Fixed<W, I, true>;
template <int W, int I>
using ufix = Fixed<W, I, false>;

template <class T, class Int>
constexpr T from_raw(Int bits) {
  return T::from_bits(bits);
}

template <class T>
constexpr bool is_set(const T& x) {
  return raw(x) != 0;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_FIXED_HPP_
