// SPDX-License-Identifier: Apache-2.0
#include "study/trade/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace halfspace::model {

namespace {

double psnr(double squares, double values, double full_scale) {
  return squares == 0 ? std::numeric_limits<double>::infinity()
                      : 10 * std::log10(full_scale * full_scale * values / squares);
}

}  // namespace

Accuracy accuracy(const ref::Frame& reference, const ref::Frame& kernels, int depth_bits) {
  Accuracy result;
  result.pixels = reference.index.size();
  double squares = 0, depth_squares = 0;
  for (std::size_t n = 0; n < reference.index.size(); ++n) {
    std::int64_t largest = 0;
    int channels = 0;
    for (int c = 0; c < 3; ++c) {
      const std::int64_t error = std::llabs(std::int64_t(reference.colour[n][c]) - kernels.colour[n][c]);
      squares += double(error * error);
      largest = std::max(largest, error);
      channels += error != 0;
    }
    const std::uint32_t index = reference.index[n];
    if (index != kernels.index[n]) {
      ++result.index_differ;
      result.covered_differ += (index == 0) != (kernels.index[n] == 0);
    } else if (index != 0) {
      const std::int64_t depth = std::llabs(std::int64_t(reference.depth[n]) - kernels.depth[n]);
      ++result.compared;
      depth_squares += double(depth) * double(depth);
      result.depth_largest = std::max(result.depth_largest, depth);
      result.depth_differ += depth != 0;
      result.colour_largest = std::max(result.colour_largest, largest);
      result.colour_differ += std::uint64_t(channels);
    }
  }
  result.depth_psnr = psnr(depth_squares, double(result.compared), std::ldexp(1, depth_bits) - 1);
  result.psnr = psnr(squares, 3 * double(result.pixels), 255);
  return result;
}

}  // namespace halfspace::model
