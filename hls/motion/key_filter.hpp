// SPDX-License-Identifier: Apache-2.0
// What a filter makes of the pixels around a place in a key frame. Sums of products are exact.
#ifndef HALFSPACE_HLS_MOTION_KEY_FILTER_HPP_
#define HALFSPACE_HLS_MOTION_KEY_FILTER_HPP_

#include "hls/motion/key_cache.hpp"
#include "hls/motion/key_weights.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

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
  const int matches = int(match[0]) | int(match[1]) << 1 | int(match[2]) << 2 | int(match[3]) << 3;
  if (matches >> nearest & 1) return nearest;
  if (matches >> (nearest ^ first) & 1) return nearest ^ first;
  if (matches >> (nearest ^ 3 ^ first) & 1) return nearest ^ 3 ^ first;
  return nearest ^ 3;
}

// At fraction t of an axis, where the two pixels about the place alone have weights.
template <class F>
AxisWeights inner_weights(const KeyWeights<F>& weights, int t) {
  const std::int16_t behind = weights.inner[t].tap[2];
  return {{0, std::int16_t((1 << F::kWeightBits) - behind), behind, 0}};
}

// Σ weights·values along an axis. The weights sum to 1, so that one of the values needs no product.
template <class F, class Sum, class Value>
Sum weighted(const AxisWeights& weights, const Value (&value)[2]) {
  return value[0] + (value[1] - value[0]) * from_raw<typename F::TapWeight>(weights.tap[2]);
}
template <class F, class Sum, class Value>
Sum weighted(const AxisWeights& weights, const Value (&value)[4]) {
  using Weight = typename F::TapWeight;
  return value[1] + (value[0] - value[1]) * from_raw<Weight>(weights.tap[0]) +
         (value[2] - value[1]) * from_raw<Weight>(weights.tap[2]) +
         (value[3] - value[1]) * from_raw<Weight>(weights.tap[3]);
}

// One channel, by the weights of its columns and rows.
template <class F, int N>
typename F::KeySum filtered_channel(const typename F::Colour (&colour)[N][N], const AxisWeights& columns,
                                    const AxisWeights& rows) {
  using Row = Refined<typename F::KeySum, typename F::TapWeight>;
  Row row[N];
Rows:
  for (int j = 0; j < N; ++j) {
    HS_UNROLL
    row[j] = weighted<F, Row>(columns, colour[j]);
  }
  return weighted<F, typename F::KeySum>(rows, row);
}

// Of N × N pixels, [row][column]: of 4 × 4 the inner four are about the place, of 2 × 2 all; nearest takes (0, 0)
// alone. Those that lie outside the frame or are of another face do not match, and their colour means nothing. tx, ty:
// the fractions of the place, g bits. Of its arguments alone: a tool may pipeline it as it is.
template <class F, int N>
KeyColour<F> filtered_key(const KeyWeights<F>& weights, const KeyPixel<F> (&pixel)[N][N], const bool (&match)[N][N],
                          int tx, int ty) {
  constexpr int k0 = N == 4 ? 1 : 0, k1 = k0 + 1;  // columns and rows of the inner four
  KeyColour<F> out;
  if (F::kFilter == KeyFilter::kNearest) {
    out.shown = match[0][0];
    out.r = pixel[0][0].r;
    out.g = pixel[0][0].g;
    out.b = pixel[0][0].b;
    return out;
  }
  const bool inner[4] = {match[k0][k0], match[k0][k1], match[k1][k0], match[k1][k1]};
  const int standing = standing_tap(inner, tx, ty, F::KeyPlace::fraction());
  const bool right = (standing & 1) != 0, below = (standing & 2) != 0;
  const AxisWeights inner_x = inner_weights<F>(weights, tx), inner_y = inner_weights<F>(weights, ty);
  // A pixel without weight shows nothing of the place: it lies on the centre of another, or next to it.
  out.shown = (inner[0] || inner[1] || inner[2] || inner[3]) && (right ? inner_x.tap[2] : inner_x.tap[1]) != 0 &&
              (below ? inner_y.tap[2] : inner_y.tap[1]) != 0;
  const KeyPixel<F> above_stands = right ? pixel[k0][k1] : pixel[k0][k0];
  const KeyPixel<F> below_stands = right ? pixel[k1][k1] : pixel[k1][k0];
  const KeyPixel<F> stands = below ? below_stands : above_stands;
  typename F::Colour r[N][N], g[N][N], b[N][N];
  bool all = N == 4;
Rows:
  for (int j = 0; j < N; ++j) {
    HS_UNROLL
  Columns:
    for (int i = 0; i < N; ++i) {
      HS_UNROLL
      const bool is_inner = i >= k0 && i <= k1 && j >= k0 && j <= k1;
      const KeyPixel<F>& at = is_inner && !match[j][i] ? stands : pixel[j][i];
      r[j][i] = at.r;
      g[j][i] = at.g;
      b[j][i] = at.b;
      all = all && match[j][i];
    }
  }
  const AxisWeights columns = N == 4 && all ? weights.outer[tx] : inner_x;
  const AxisWeights rows = N == 4 && all ? weights.outer[ty] : inner_y;
  out.r = filtered_channel<F>(r, columns, rows);
  out.g = filtered_channel<F>(g, columns, rows);
  out.b = filtered_channel<F>(b, columns, rows);
  return out;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_KEY_FILTER_HPP_
