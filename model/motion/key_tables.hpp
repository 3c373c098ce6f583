// SPDX-License-Identifier: Apache-2.0
// What kernels with formats at run time know of key frames: the tables of a filter.
#ifndef HALFSPACE_MODEL_MOTION_KEY_TABLES_HPP_
#define HALFSPACE_MODEL_MOTION_KEY_TABLES_HPP_

#include <vector>

#include "hls/motion/key_weights.hpp"
#include "model/formats/runtime_formats.hpp"

namespace halfspace {

// The tables of the configuration that was active when they were made.
template <class S>
struct KeyWeights<RuntimeFormats<S>> {
  using F = RuntimeFormats<S>;
  std::vector<AxisWeights> inner, outer;

  KeyWeights() {
    const int g = F::kVectorFraction + F::kLog2Samples;
    for (int n = 0; n < 1 << g; ++n) {
      inner.push_back(axis_weights(inner_filter(F::kFilter), n, g, F::kWeightBits));
      outer.push_back(axis_weights(F::kFilter, n, g, F::kWeightBits));
    }
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_MODEL_MOTION_KEY_TABLES_HPP_
