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
// One rounding, half up, then clamped. One word a call.
//
// Interval of the RTL: a pixel a cycle, and 1 + (8/N)² for a tile that a cache lacks; the two keys fetch at the same
// time.
#ifndef HALFSPACE_HLS_MOTION_MOTION_COMPENSATE_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_COMPENSATE_HPP_

#include "hls/motion/key_filter.hpp"

namespace halfspace {

// What comes of a key for a pixel, if the word has a vector to it: of what was fetched alone.
template <class F, int N>
KeyColour<F> key_colour(const KeyWeights<F>& weights, const Motion<F>& in, const KeyVector<F>& v,
                        const KeyAxis<typename F::TileX, N>& columns, const KeyAxis<typename F::TileY, N>& rows,
                        const KeyPixel<F> (&pixel)[N][N]) {
  const bool there = is_set(in.face) && is_set(v.there);
  bool match[N][N];
Rows:
  for (int j = 0; j < N; ++j) {
    HS_UNROLL
  Columns:
    for (int i = 0; i < N; ++i) {
      HS_UNROLL
      match[j][i] = there && columns.inside[i] && rows.inside[j] && pixel[j][i].face == in.face;
    }
  }
  KeyColour<F> out = filtered_key<F, N>(weights, pixel, match, columns.fraction, rows.fraction);
  if (F::kRelights) {
    using KeySum = typename F::KeySum;
    const KeySum zero = from_raw<KeySum>(1 << (F::kColourBits + 2 * F::kWeightBits));
    const int places = 2 * F::kWeightBits - kDifferenceFraction;
    out.r = out.r + shift_left(slice<KeySum>(v.r, 0), places) - zero;
    out.g = out.g + shift_left(slice<KeySum>(v.g, 0), places) - zero;
    out.b = out.b + shift_left(slice<KeySum>(v.b, 0), places) - zero;
  }
  return out;
}

// `weight` is key 0's.
template <class F>
typename F::Colour blended(const typename F::KeySum& key_0, const typename F::KeySum& key_1,
                           const typename F::KeyWeight& weight) {
  using Blend = typename F::KeyBlend;
  using Level = Whole<Wider<Blend, 1>>;
  const Blend sum = key_1 + (key_0 - key_1) * weight;
  const Level level = sum + from_raw<Blend>(1 << (3 * F::kWeightBits - 1));
  const Level most = from_raw<Level>((1 << F::kColourBits) - 1);
  return select(is_negative(level), from_raw<Level>(0), select(level > most, most, level));
}

// The word that is sent for one of motion.
template <class F>
Compensated<F> compensated_pixel(const CompensationFrame<F>& frame, const Motion<F>& in, const KeyColour<F>& key_0,
                                 const KeyColour<F>& key_1) {
  using Weight = typename F::KeyWeight;
  Compensated<F> out;
  out.last = in.last;
  out.x = in.x;
  out.y = in.y;
  out.keys = from_raw<Keys>(int(key_1.shown) << 1 | int(key_0.shown));
  out.r = out.g = out.b = typename F::Colour();
  if (key_0.shown || key_1.shown) {
    const Weight weight = select(!key_1.shown, from_raw<Weight>(1 << F::kWeightBits),
                                 select(key_0.shown, frame.weight, from_raw<Weight>(0)));
    out.r = blended<F>(key_0.r, key_1.r, weight);
    out.g = blended<F>(key_0.g, key_1.g, weight);
    out.b = blended<F>(key_0.b, key_1.b, weight);
  }
  return out;
}

// Fetches what the cache of a key lacks, reads it, and makes of it what comes of the key. Inline, as Bambu takes
// streams in a top alone.
template <class F, int N, class Memory>
HS_INLINE inline KeyColour<F> fetched_colour(const CompensationFrame<F>& frame, const KeyWeights<F>& weights,
                                             const Motion<F>& in, const KeyVector<F>& v, KeyCache<F, N>& cache,
                                             Memory& memory) {
  const KeyNumber<F> width = key_pixels<F>(frame.width), height = key_pixels<F>(frame.height);
  const KeyAxis<typename F::TileX, N> columns = key_axis<F, typename F::TileX, N>(width, in.x, v.x);
  const KeyAxis<typename F::TileY, N> rows = key_axis<F, typename F::TileY, N>(height, in.y, v.y);
  if (is_set(in.face) && is_set(v.there) && columns.any_inside && rows.any_inside) {
    fill_cache(cache, columns, rows, memory);
  }
  KeyPixel<F> pixel[N][N];
  read_cache(cache, columns.first, rows.first, pixel);
  return key_colour<F, N>(weights, in, v, columns, rows, pixel);
}

// memory_k: of key frame k, as fill_cache asks it. The caches are empty before the first word, and after the last one
// of a frame.
template <class F, int N, class Memory>
bool motion_compensate(const CompensationFrame<F>& frame, const KeyWeights<F>& weights, KeyCache<F, N>& cache_0,
                       KeyCache<F, N>& cache_1, Memory& memory_0, Memory& memory_1, Stream<Motion<F>>& motion,
                       Stream<Compensated<F>>& compensated) {
  const Motion<F> in = motion.read();
  const KeyColour<F> key_0 = fetched_colour<F, N>(frame, weights, in, in.key[0], cache_0, memory_0);
  const KeyColour<F> key_1 = fetched_colour<F, N>(frame, weights, in, in.key[1], cache_1, memory_1);
  compensated.write(compensated_pixel(frame, in, key_0, key_1));
  if (is_set(in.last)) {
    empty_cache(cache_0);
    empty_cache(cache_1);
  }
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_COMPENSATE_HPP_
