// SPDX-License-Identifier: Apache-2.0
// The pixels that the units handle in one cycle.
#ifndef HALFSPACE_HLS_FORMATS_STAMP_HPP_
#define HALFSPACE_HLS_FORMATS_STAMP_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

// Stamps that `pixels` pixels take, `lanes` a stamp.
constexpr int stamps_for(int pixels, int lanes) { return (pixels + lanes - 1) / lanes; }

// A stamp is the X × Y block of pixels that the units handle in one cycle, one lane a pixel. Lane l is the pixel
// (l mod X, l div X) of its stamp.
template <int X, int Y>
struct StampShape {
  static constexpr int kX = X, kY = Y;
};
using Stamp1 = StampShape<1, 1>;
using Stamp2 = StampShape<2, 1>;
using Stamp4 = StampShape<2, 2>;
using Stamp8 = StampShape<4, 2>;
using Stamp16 = StampShape<4, 4>;

// What the kernels' views of a configuration say of stamp S.
template <class S>
struct StampConstants {
  static constexpr int kLanesX = S::kX, kLanesY = S::kY, kLanes = S::kX * S::kY;
  static constexpr int kLog2LanesX = exact_log2(kLanesX), kLog2LanesY = exact_log2(kLanesY);
  static_assert(kLanesX == 1 << kLog2LanesX && kLanesY == 1 << kLog2LanesY && kLanesX <= 4 && kLanesY <= 4,
                "a stamp is a power of two of pixels each way, and 4 at most");
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_STAMP_HPP_
