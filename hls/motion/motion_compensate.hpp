// SPDX-License-Identifier: Apache-2.0
// Compensation: the colour of a pixel of a frame in between from the two key frames, along its vectors.
//
//   place in key k   (x + ½ + vx_k, y + ½ + vy_k) / samples, in pixels of the key frame; their centres are at ½
//   taps             the pixel that it lies in (nearest); the 2 × 2 whose centres are around it; the 4 × 4 of these
//   (bicubic)
//
// A tap matches if it is in the frame and of the face of the word: others show something else, and would be a smear. Of
// the inner four the weight of those that do not match goes to the matching one with the largest. A bicubic filter
// needs all sixteen, and is a bilinear one of the inner four else. Where no tap with a weight matches, the key does not
// show the point.
//
//   V_k = Σ weights · colours + what the colour in between differs by      exact, 2w fraction bits
//   both keys: W·V_0 + (1 − W)·V_1;  one: it alone;  none: a hole, which is not filled here
//
// One rounding, half up, then clamped. One word a call. Cycles in the RTL: one a word, and for the tiles that the
// caches of the two keys lack, which they fetch at the same time, 1 + (8/N)² a tile.
#ifndef HALFSPACE_HLS_MOTION_MOTION_COMPENSATE_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_COMPENSATE_HPP_

#include "hls/motion/key_cache.hpp"
#include "hls/motion/key_filter.hpp"

namespace halfspace {

// The memory and the cache of a key frame.
template <class F, int N>
struct KeyPort {
  KeyCache<F, N>* cache;
  const KeyBlock<F, N>* memory;
  Probe<KeyRequest<F>>* request;
  Probe<KeyBlock<F, N>>* block;
};

// Pixels of a key frame for so many in between.
template <class F>
int key_pixels(int pixels) {
  return (pixels + (1 << F::kLog2Samples) - 1) >> F::kLog2Samples;
}

template <class F, int N>
KeyColour<F> key_colour(const CompensationFrame<F>& frame, const KeyWeights<F>& weights, const Motion<F>& in,
                        const KeyVector<F>& v, const KeyPort<F, N>& port) {
  constexpr int kLast = kMostTaps - 1;
  const bool nearest = F::kFilter == KeyFilter::kNearest;
  const int width = key_pixels<F>(int(raw(frame.width))), height = key_pixels<F>(int(raw(frame.height)));
  // Whole numbers of 2^−g pixels of the key frame. Nearest: the pixel of the place itself; else the one before its
  // centre.
  const int f = F::kVectorFraction, g = f + F::kLog2Samples, half = nearest ? 0 : 1 << (g - 1);
  const int place_x = (2 * int(raw(in.x)) + 1) * (1 << (f - 1)) + int(raw(v.x)) - half;
  const int place_y = (2 * int(raw(in.y)) + 1) * (1 << (f - 1)) + int(raw(v.y)) - half;
  const int column = place_x >> g, row = place_y >> g, mask = (1 << g) - 1;
  const int before = N == 4 ? 1 : 0, after = N == 4 ? 2 : nearest ? 0 : 1;
  KeyTaps<F> taps;
  KeyArea area;
  const bool there = raw(in.face) != 0 && raw(v.there) != 0;
  area.left = column - before > 0 ? column - before : 0;
  area.top = row - before > 0 ? row - before : 0;
  area.right = !there ? -1 : column + after < width ? column + after : width - 1;
  area.bottom = row + after < height ? row + after : height - 1;
  fill_cache(*port.cache, area, port.memory, (width + kKeyTile - 1) / kKeyTile, *port.request, *port.block);
Rows:
  for (int j = 0; j <= kLast; ++j) {
    HS_UNROLL
  Columns:
    for (int i = 0; i <= kLast; ++i) {
      HS_UNROLL
      const int x = column - 1 + i, y = row - 1 + j, n = kMostTaps * j + i;
      taps.match[n] = false;
      taps.r[n] = taps.g[n] = taps.b[n] = typename F::Colour();
      if (x < area.left || x > area.right || y < area.top || y > area.bottom) continue;
      const KeyPixel<F>& pixel = cached_pixel(*port.cache, x, y);
      taps.match[n] = raw(pixel.face) == raw(in.face);
      taps.r[n] = pixel.r;
      taps.g[n] = pixel.g;
      taps.b[n] = pixel.b;
    }
  }
  KeyColour<F> out = filtered_key<F>(weights, taps, place_x & mask, place_y & mask);
  if (F::kRelights) {
    const std::int64_t zero = std::int64_t(1) << (F::kColourBits + kDifferenceFraction);
    const int places = 2 * F::kWeightBits - kDifferenceFraction;
    out.r = from_raw<typename F::KeySum>(std::int64_t(raw(out.r)) + (std::int64_t(raw(v.r)) - zero) * (1 << places));
    out.g = from_raw<typename F::KeySum>(std::int64_t(raw(out.g)) + (std::int64_t(raw(v.g)) - zero) * (1 << places));
    out.b = from_raw<typename F::KeySum>(std::int64_t(raw(out.b)) + (std::int64_t(raw(v.b)) - zero) * (1 << places));
  }
  return out;
}

// `weight` of 2^w is key 0's.
template <class F>
typename F::Colour blended(const typename F::KeySum& key_0, const typename F::KeySum& key_1, int weight) {
  const int w = F::kWeightBits;
  const std::int64_t sum = weight * std::int64_t(raw(key_0)) + ((1 << w) - weight) * std::int64_t(raw(key_1));
  const std::int64_t rounded =
      (std::int64_t(raw(from_raw<typename F::KeyBlend>(sum))) + (std::int64_t(1) << (3 * w - 1))) >> 3 * w;
  const std::int64_t most = (1 << F::kColourBits) - 1;
  return from_raw<typename F::Colour>(rounded < 0 ? 0 : rounded > most ? most : rounded);
}

// Port k is key k's. The caches are empty before the first word, and after the last one of a frame.
template <class F, int N>
bool motion_compensate(const CompensationFrame<F>& frame, const KeyWeights<F>& weights, Stream<Motion<F>>& motion,
                       const KeyPort<F, N> (&port)[kKeys], Stream<Compensated<F>>& compensated) {
  const Motion<F> in = motion.read();
  const KeyColour<F> key_0 = key_colour<F, N>(frame, weights, in, in.key[0], port[0]);
  const KeyColour<F> key_1 = key_colour<F, N>(frame, weights, in, in.key[1], port[1]);
  Compensated<F> out;
  out.last = in.last;
  out.x = in.x;
  out.y = in.y;
  out.keys = from_raw<Keys>(int(key_1.shown) << 1 | int(key_0.shown));
  out.r = out.g = out.b = typename F::Colour();
  if (key_0.shown || key_1.shown) {
    const int weight = !key_1.shown ? 1 << F::kWeightBits : !key_0.shown ? 0 : int(raw(frame.weight));
    out.r = blended<F>(key_0.r, key_1.r, weight);
    out.g = blended<F>(key_0.g, key_1.g, weight);
    out.b = blended<F>(key_0.b, key_1.b, weight);
  }
  compensated.write(out);
  if (raw(in.last)) {
    empty_cache(*port[0].cache);
    empty_cache(*port[1].cache);
  }
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_COMPENSATE_HPP_
