// SPDX-License-Identifier: Apache-2.0
// The cache of a key frame: 2 × 2 tiles of 8 × 8 pixels, direct-mapped by the parity of a tile's column and row. The
// pixels of one filter lie in at most two columns and two rows of tiles next to each other, so that none of them drives
// out another. N × N banks, by column and row modulo N: the pixels of a filter are each in a bank of its own, and a
// block of a tile fills all banks at one address.
#ifndef HALFSPACE_HLS_MOTION_KEY_CACHE_HPP_
#define HALFSPACE_HLS_MOTION_KEY_CACHE_HPP_

#include "hls/formats/key_records.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

constexpr int kCacheSlots = 4;
// Blocks of a tile, and of a row of it.
constexpr int blocks_a_row(int n) { return kKeyTile / n; }
constexpr int blocks_a_tile(int n) { return blocks_a_row(n) * blocks_a_row(n); }

template <class F>
struct KeyPixel {
  typename F::Colour r, g, b;
  typename F::Face face;
};

template <class F, int N>
struct KeyCache {
  bool valid[kCacheSlots];
  KeyRequest<F> tag[kCacheSlots];
  KeyPixel<F> bank[N * N][kCacheSlots * blocks_a_tile(N)];
};

// What a filter looks at, in pixels of the key frame: columns left … right, rows top … bottom, inside the frame; empty
// where one is beyond the other.
struct KeyArea {
  int left, top, right, bottom;
};

template <class F, int N>
void empty_cache(KeyCache<F, N>& cache) {
Slots:
  for (int slot = 0; slot < kCacheSlots; ++slot) {
    HS_UNROLL
    cache.valid[slot] = false;
  }
}

// Fetches what the cache lacks of an area, slot after slot. `memory` has the blocks of tile (x, y) from
// (y · tiles_x + x) · blocks_a_tile on, row by row.
template <class F, int N>
void fill_cache(KeyCache<F, N>& cache, const KeyArea& area, const KeyBlock<F, N>* memory, int tiles_x,
                Probe<KeyRequest<F>>& request, Probe<KeyBlock<F, N>>& block) {
  if (area.left > area.right || area.top > area.bottom) return;
  const int x0 = area.left / kKeyTile, x1 = area.right / kKeyTile, y0 = area.top / kKeyTile,
            y1 = area.bottom / kKeyTile;
Slots:
  for (int slot = 0; slot < kCacheSlots; ++slot) {
    // The column and the row of this parity, if the area has them.
    const int x = (x0 & 1) == (slot & 1) ? x0 : x1, y = (y0 & 1) == slot >> 1 ? y0 : y1;
    if ((x & 1) != (slot & 1) || (y & 1) != slot >> 1) continue;
    KeyRequest<F> tag;
    tag.tile_x = from_raw<typename F::TileX>(x);
    tag.tile_y = from_raw<typename F::TileY>(y);
    const bool hit = cache.valid[slot] && raw(cache.tag[slot].tile_x) == raw(tag.tile_x) &&
                     raw(cache.tag[slot].tile_y) == raw(tag.tile_y);
    if (hit) continue;
    request.write(tag);
  Blocks:
    for (int n = 0; n < blocks_a_tile(N); ++n) {
      HS_PIPELINE(1)
      const KeyBlock<F, N> in = memory[(y * tiles_x + x) * blocks_a_tile(N) + n];
      block.write(in);
    Banks:
      for (int bank = 0; bank < N * N; ++bank) {
        HS_UNROLL
        KeyPixel<F>& pixel = cache.bank[bank][slot * blocks_a_tile(N) + n];
        pixel.r = in.r[bank];
        pixel.g = in.g[bank];
        pixel.b = in.b[bank];
        pixel.face = in.face[bank];
      }
    }
    cache.valid[slot] = true;
    cache.tag[slot] = tag;
  }
}

// Pixel (x, y) of the key frame, of which the cache holds the tile.
template <class F, int N>
const KeyPixel<F>& cached_pixel(const KeyCache<F, N>& cache, int x, int y) {
  const int slot = (y / kKeyTile & 1) << 1 | (x / kKeyTile & 1);
  const int n = y % kKeyTile / N * blocks_a_row(N) + x % kKeyTile / N;
  return cache.bank[y % N * N + x % N][slot * blocks_a_tile(N) + n];
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_KEY_CACHE_HPP_
