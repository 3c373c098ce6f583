// SPDX-License-Identifier: Apache-2.0
// The weights of the pixels around a place in a key frame. They are separable; along an axis with t from the
// centre of the pixel before the place to that of the one behind it, in [0, 1):
//
//   bilinear   1 − t, t: the areas that a unit pixel about the place shares with them
//   area       those areas, each divided by the distance of its pixel: (1 − t)/t to t/(1 − t), which over their sum are
//              (1 − t)²/d, t²/d, d = (1 − t)² + t²
//   bicubic    Catmull and Rom: (−t + 2t² − t³)/2, (2 − 5t² + 3t³)/2, (t + 4t² − 3t³)/2, (t³ − t²)/2
//
// A table has them as whole numbers of 2^−w: each rounded half up, and what their sum then lacks of 1 is added to the
// largest, so that a picture of one colour keeps it. Sums of products are exact.
#ifndef HALFSPACE_HLS_MOTION_KEY_WEIGHTS_HPP_
#define HALFSPACE_HLS_MOTION_KEY_WEIGHTS_HPP_

#include "hls/formats/key_records.hpp"

namespace halfspace {

// Of the pixels one before the place and another, one behind it and another: in the order of their columns.
constexpr int kMostTaps = 4;
struct AxisWeights {
  std::int16_t tap[kMostTaps];
};

// n/d of 2^w, each rounded half up; the rest to the largest, the first of these if there are two.
constexpr AxisWeights rounded_weights(const std::int64_t (&n)[kMostTaps], std::int64_t d, int w) {
  AxisWeights out{};
  std::int64_t rest = std::int64_t(1) << w;
  int largest = 0;
  for (int i = 0; i < kMostTaps; ++i) {
    // Floor, where the division of C++ is not.
    const std::int64_t twice = n[i] * (std::int64_t(1) << (w + 1)) + d;
    const std::int64_t weight = twice >= 0 ? twice / (2 * d) : -((-twice + 2 * d - 1) / (2 * d));
    out.tap[i] = std::int16_t(weight);
    rest -= weight;
    if (n[i] > n[largest]) largest = i;
  }
  out.tap[largest] = std::int16_t(out.tap[largest] + rest);
  return out;
}

// At t = n·2^−g.
constexpr AxisWeights axis_weights(KeyFilter filter, std::int64_t n, int g, int w) {
  const std::int64_t one = std::int64_t(1) << g, m = one - n;
  if (filter == KeyFilter::kBicubic) {
    const std::int64_t taps[kMostTaps] = {-n * m * m, 2 * one * one * one - 5 * one * n * n + 3 * n * n * n,
                                          one * one * n + 4 * one * n * n - 3 * n * n * n, -n * n * m};
    return rounded_weights(taps, 2 * one * one * one, w);
  }
  const bool by_area = filter == KeyFilter::kArea;
  const std::int64_t before = by_area ? m * m : m, behind = by_area ? n * n : n;
  const std::int64_t taps[kMostTaps] = {0, before, behind, 0};
  return rounded_weights(taps, before + behind, w);
}

// The tables of a configuration: at t = n·2^−g, entry n. `outer` is of bicubic filters alone; `inner` is of those where
// a pixel of the sixteen is missing, too.
constexpr KeyFilter inner_filter(KeyFilter filter) {
  return filter == KeyFilter::kArea ? filter : KeyFilter::kBilinear;
}
template <class F>
struct KeyWeights {
  static constexpr int kFraction = F::kVectorFraction + F::kLog2Samples;
  static constexpr int kOuter = F::kFilter == KeyFilter::kBicubic ? 1 << kFraction : 1;
  AxisWeights inner[1 << kFraction], outer[kOuter];
};
template <class F>
constexpr KeyWeights<F> key_weights() {
  KeyWeights<F> weights{};
  const int g = KeyWeights<F>::kFraction, w = F::kWeightBits;
  for (int n = 0; n < 1 << g; ++n) {
    weights.inner[n] = axis_weights(inner_filter(F::kFilter), n, g, w);
    if (F::kFilter == KeyFilter::kBicubic) weights.outer[n] = axis_weights(F::kFilter, n, g, w);
  }
  return weights;
}

// Whether they are what formats.hpp says. With p the positive part of a sum of 1 and p − 1 the negative one, two axes
// reach from −2p(p − 1) to p² + (p − 1)² of full scale: −½ and 3/2 are what key_sum has room for.
constexpr bool weights_fit(KeyFilter filter, int g, int w) {
  for (int n = 0; n < 1 << g; ++n) {
    const AxisWeights weights = axis_weights(filter, n, g, w);
    std::int64_t sum = 0, positive = 0;
    for (int i = 0; i < kMostTaps; ++i) {
      const std::int64_t weight = weights.tap[i];
      sum += weight;
      positive += weight > 0 ? weight : 0;
      if (2 * weight < -(1 << w) || weight > 1 << w) return false;
    }
    const std::int64_t negative = positive - (1 << w), one = std::int64_t(1) << 2 * w;
    if (sum != 1 << w || 4 * positive * negative > one) return false;
    if (2 * (positive * positive + negative * negative) > 3 * one) return false;
  }
  return true;
}

static_assert(weights_fit(KeyFilter::kBilinear, 5, 4) && weights_fit(KeyFilter::kArea, 5, 6) &&
                  weights_fit(KeyFilter::kBicubic, 6, 2) && weights_fit(KeyFilter::kBicubic, 8, 8),
              "the weights of an axis sum to 1, and two axes to no more than key_sum holds");

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_KEY_WEIGHTS_HPP_
