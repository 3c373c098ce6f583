// SPDX-License-Identifier: Apache-2.0
// What a filter takes of the pixels around a place in a key frame. Weights are separable; along an axis with t from the
// centre of the pixel before the place to that of the one behind it, in [0, 1):
//
//   bilinear   1 − t, t: the areas that a unit pixel about the place shares with them
//   area       those areas, each divided by the distance of its pixel: (1 − t)/t to t/(1 − t), which over their sum are
//              (1 − t)²/d, t²/d, d = (1 − t)² + t²
//   bicubic    Catmull and Rom: (−t + 2t² − t³)/2, (2 − 5t² + 3t³)/2, (t + 4t² − 3t³)/2, (t³ − t²)/2
//
// A table has them as whole numbers of 2^−w: each rounded half up, and what their sum then lacks of 1 is added to the
// largest, so that a picture of one colour keeps it. Sums of products are exact.
#ifndef HALFSPACE_HLS_MOTION_KEY_FILTER_HPP_
#define HALFSPACE_HLS_MOTION_KEY_FILTER_HPP_

#include "hls/formats/key_records.hpp"
#include "hls/numbers/stream.hpp"

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

// The pixels that a filter takes, 4 by 4 in the order of rows; nearest (1, 1) alone, others but bicubic the inner four.
// Those that lie outside the frame or are of another face do not match, and their colour means nothing.
template <class F>
struct KeyTaps {
  bool match[kMostTaps * kMostTaps];
  typename F::Colour r[kMostTaps * kMostTaps], g[kMostTaps * kMostTaps], b[kMostTaps * kMostTaps];
};

// What one key makes of a pixel in between.
template <class F>
struct KeyColour {
  bool shown;  // a tap matches that has a weight
  typename F::KeySum r, g, b;
};

// Of the inner four, the number of the one that stands for those that do not match: the matching one with the largest
// weight. That is the nearest, or the other of its row or of its column, where the place is nearer to the middle, or
// the one opposite. 0 … 3: bit 0 the column, bit 1 the row; with none of them, the one opposite.
inline int standing_tap(const bool (&match)[4], int tx, int ty, int g) {
  const int half = 1 << (g - 1), right = tx >= half, below = ty >= half, nearest = below << 1 | right;
  const int from_x = right ? tx - half : half - tx, from_y = below ? ty - half : half - ty;
  const int first = from_x <= from_y ? 1 : 2;
  if (match[nearest]) return nearest;
  if (match[nearest ^ first]) return nearest ^ first;
  if (match[nearest ^ 3 ^ first]) return nearest ^ 3 ^ first;
  return nearest ^ 3;
}

// One channel, by the weights of its columns and rows.
template <class F>
typename F::KeySum filtered_channel(const typename F::Colour (&colour)[kMostTaps * kMostTaps],
                                    const AxisWeights& columns, const AxisWeights& rows) {
  std::int64_t sum = 0;
Rows:
  for (int j = 0; j < kMostTaps; ++j) {
    HS_UNROLL
    std::int32_t row = 0;
  Columns:
    for (int i = 0; i < kMostTaps; ++i) {
      HS_UNROLL
      row += std::int32_t(columns.tap[i]) * std::int32_t(raw(colour[kMostTaps * j + i]));
    }
    sum += std::int64_t(rows.tap[j]) * row;
  }
  return from_raw<typename F::KeySum>(sum);
}

// tx, ty: the fractions of the place, g bits.
template <class F>
KeyColour<F> filtered_key(const KeyWeights<F>& weights, KeyTaps<F> taps, int tx, int ty) {
  static constexpr int kInner[4] = {5, 6, 9, 10};
  const int g = F::kVectorFraction + F::kLog2Samples;
  KeyColour<F> out;
  if (F::kFilter == KeyFilter::kNearest) {
    out.shown = taps.match[kInner[0]];
    out.r = from_raw<typename F::KeySum>(std::int64_t(raw(taps.r[kInner[0]])) << 2 * F::kWeightBits);
    out.g = from_raw<typename F::KeySum>(std::int64_t(raw(taps.g[kInner[0]])) << 2 * F::kWeightBits);
    out.b = from_raw<typename F::KeySum>(std::int64_t(raw(taps.b[kInner[0]])) << 2 * F::kWeightBits);
    return out;
  }
  bool inner[4], all = F::kFilter == KeyFilter::kBicubic;
Matches:
  for (int i = 0; i < kMostTaps * kMostTaps; ++i) {
    HS_UNROLL
    all = all && taps.match[i];
  }
Inner:
  for (int i = 0; i < 4; ++i) {
    HS_UNROLL
    inner[i] = taps.match[kInner[i]];
  }
  const int number = standing_tap(inner, tx, ty, g), standing = kInner[number];
  // A pixel without weight shows nothing of the place: it lies on the centre of another, or next to it.
  out.shown = taps.match[standing] && weights.inner[tx].tap[1 + (number & 1)] != 0 &&
              weights.inner[ty].tap[1 + (number >> 1)] != 0;
Stand:
  for (int i = 0; i < 4; ++i) {
    HS_UNROLL
    if (inner[i]) continue;
    taps.r[kInner[i]] = taps.r[standing];
    taps.g[kInner[i]] = taps.g[standing];
    taps.b[kInner[i]] = taps.b[standing];
  }
  const AxisWeights columns = all ? weights.outer[tx] : weights.inner[tx];
  const AxisWeights rows = all ? weights.outer[ty] : weights.inner[ty];
  out.r = filtered_channel<F>(taps.r, columns, rows);
  out.g = filtered_channel<F>(taps.g, columns, rows);
  out.b = filtered_channel<F>(taps.b, columns, rows);
  return out;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_KEY_FILTER_HPP_
