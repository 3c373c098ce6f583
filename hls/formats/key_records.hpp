// SPDX-License-Identifier: Apache-2.0
// The records of motion_compensate. Pixels of key frames come in blocks of N × N, N = key_side(F::kFilter): one for
// each bank of a cache.
#ifndef HALFSPACE_HLS_FORMATS_KEY_RECORDS_HPP_
#define HALFSPACE_HLS_FORMATS_KEY_RECORDS_HPP_

#include "hls/formats/records.hpp"

namespace halfspace {

// A frame's registers: stable from its first word to its last.
template <class F>
struct CompensationFrame {
  typename F::X width;  // in pixels in between
  typename F::Y height;
  typename F::KeyWeight weight;  // of key 0; key 1 has the rest
};

// That weight as a word, where a stream has to set it.
template <class F>
struct KeyWeightWord {
  typename F::KeyWeight weight;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("weight", weight);
  }
};

// motion_compensate → key memory: a tile that its cache has not; one stream a key.
template <class F>
struct KeyRequest {
  typename F::TileX tile_x;
  typename F::TileY tile_y;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("tile_x", tile_x), v("tile_y", tile_y);
  }
};

// Key memory → motion_compensate, in answer: (8/N)² blocks of a tile, row by row; lane l is pixel (l mod N, l div N) of
// its block. Beyond the frame it holds anything.
template <class F, int N>
struct KeyBlock {
  typename F::Colour r[N * N], g[N * N], b[N * N];
  typename F::Face face[N * N];  // 0: background, or more than one face

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v.lanes("r", r), v.lanes("g", g), v.lanes("b", b), v.lanes("face", face);
  }
};

using Keys = FlagFormats<Fixed>::Keys;

// motion_compensate → frame, a word a word of motion.
template <class F>
struct Compensated {
  typename F::Bit last;
  typename F::X x;
  typename F::Y y;
  typename F::Colour r, g, b;  // 0 without a key: a hole, or the background
  typename F::Keys keys;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y), v("r", r), v("g", g), v("b", b), v("keys", keys);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_KEY_RECORDS_HPP_
