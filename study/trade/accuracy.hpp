// SPDX-License-Identifier: Apache-2.0
// The kernels held against the floating-point reference, in LSB and dB.
#ifndef HALFSPACE_STUDY_TRADE_ACCURACY_HPP_
#define HALFSPACE_STUDY_TRADE_ACCURACY_HPP_

#include <cstdint>

#include "ref/raster/raster.hpp"

namespace halfspace::model {

struct Accuracy {
  std::uint64_t pixels = 0;
  std::uint64_t covered_differ = 0;  // one shows a triangle, the other the background
  std::uint64_t index_differ = 0;
  // Where the indices agree and are not the background; without depth the depths are equal:
  std::uint64_t compared = 0;
  std::int64_t depth_largest = 0;  // LSB of the stored depth
  std::uint64_t depth_differ = 0;
  std::int64_t colour_largest = 0;  // LSB of 8 bits
  std::uint64_t colour_differ = 0;  // channels
  // Peak signal-to-noise ratios, dB, infinite when equal: of the stored depths compared, against full scale, and of
  // all channels of the whole frame.
  double depth_psnr = 0, psnr = 0;
};

Accuracy accuracy(const ref::Frame& reference, const ref::Frame& kernels, int depth_bits);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_TRADE_ACCURACY_HPP_
