// SPDX-License-Identifier: Apache-2.0
// The cache of a key frame: 2 × 2 tiles of 8 × 8 pixels, direct-mapped by the parity of a tile's column and row. The
// pixels of one filter lie in at most two columns and two rows of tiles next to each other, so that none of them drives
// out another. N × N banks, by column and row modulo N: the pixels of a filter are each in a bank of its own, and a
// block of a tile fills all banks at one address.
#ifndef HALFSPACE_HLS_MOTION_KEY_CACHE_HPP_
#define HALFSPACE_HLS_MOTION_KEY_CACHE_HPP_

#include "hls/motion/key_place.hpp"

namespace halfspace {

constexpr int kCacheSlots = 4;
// Blocks of a tile, and of a row of it.
constexpr int blocks_a_row(int n) { return kKeyTile / n; }
constexpr int blocks_a_tile(int n) { return blocks_a_row(n) * blocks_a_row(n); }

template <class F>
struct KeyPixel {
  typename F::Colour r, g, b;
  typename F::Face face;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("r", r), v("g", g), v("b", b), v("face", face);
  }
};

template <class F, int N>
struct KeyCache {
  bool valid[kCacheSlots];
  KeyRequest<F> tag[kCacheSlots];
  KeyPixel<F> bank[N * N][kCacheSlots * blocks_a_tile(N)];
};

template <class F, int N>
void empty_cache(KeyCache<F, N>& cache) {
Slots:
  for (int slot = 0; slot < kCacheSlots; ++slot) {
    HS_UNROLL
    cache.valid[slot] = false;
  }
}

// The tile of an axis that has this parity, if there is one.
template <class Tile>
struct ParityTile {
  bool is_there;
  Tile tile;
};
template <class Tile, int N>
ParityTile<Tile> tile_of(const KeyAxis<Tile, N>& axis, int parity) {
  ParityTile<Tile> out;
  out.tile = select(int(raw(slice<Bit>(axis.first_tile, 0))) == parity, axis.first_tile, axis.last_tile);
  out.is_there = int(raw(slice<Bit>(out.tile, 0))) == parity;
  return out;
}

// Fetches what the cache lacks of the tiles of both axes, slot after slot. A `memory` is asked by request(tile), and
// read() then gives the blocks of the tile, row by row.
template <class F, int N, class Memory>
HS_INLINE inline void fill_cache(KeyCache<F, N>& cache, const KeyAxis<typename F::TileX, N>& columns,
                                 const KeyAxis<typename F::TileY, N>& rows, Memory& memory) {
Tiles:
  for (int slot = 0; slot < kCacheSlots; ++slot) {
    const ParityTile<typename F::TileX> x = tile_of(columns, slot & 1);
    const ParityTile<typename F::TileY> y = tile_of(rows, slot >> 1);
    const bool hit = cache.valid[slot] && cache.tag[slot].tile_x == x.tile && cache.tag[slot].tile_y == y.tile;
    if (!x.is_there || !y.is_there || hit) continue;
    KeyRequest<F> tag;
    tag.tile_x = x.tile;
    tag.tile_y = y.tile;
    memory.request(tag);
  Blocks:
    for (int n = 0; n < blocks_a_tile(N); ++n) {
      HS_PIPELINE(1)
      const KeyBlock<F, N> in = memory.read();
    Banks:
      for (int bank = 0; bank < N * N; ++bank) {
        HS_UNROLL
        KeyPixel<F> pixel;
        pixel.r = in.r[bank];
        pixel.g = in.g[bank];
        pixel.b = in.b[bank];
        pixel.face = in.face[bank];
        cache.bank[bank][slot * blocks_a_tile(N) + n] = pixel;
      }
    }
    cache.valid[slot] = true;
    cache.tag[slot] = tag;
  }
}

// Of pixel (column, row) of the key frame, of which the cache holds the tile, the address in its bank.
template <int N>
int bank_address(int column, int row) {
  constexpr int kLog2 = exact_log2(N);
  const int slot = (row >> kLog2KeyTile & 1) << 1 | (column >> kLog2KeyTile & 1);
  const int block_x = column >> kLog2 & (blocks_a_row(N) - 1), block_y = row >> kLog2 & (blocks_a_row(N) - 1);
  return slot * blocks_a_tile(N) + block_y * blocks_a_row(N) + block_x;
}

// What was at (i + by) modulo N of each line comes to i.
template <class T, int N>
void rotate(T (&pixel)[N][N], int by_columns, int by_rows) {
  T turned[N][N];
From:
  for (int j = 0; j < N; ++j) {
    HS_UNROLL
  FromColumn:
    for (int i = 0; i < N; ++i) {
      HS_UNROLL
      turned[j][i] = pixel[(j + by_rows) & (N - 1)][(i + by_columns) & (N - 1)];
    }
  }
To:
  for (int j = 0; j < N; ++j) {
    HS_UNROLL
  ToColumn:
    for (int i = 0; i < N; ++i) {
      HS_UNROLL
      pixel[j][i] = turned[j][i];
    }
  }
}

// The N × N pixels from (column, row) of the key frame on, of which the cache holds the tiles: one of each bank, and
// then turned until (i, j) of them is at (i, j). Where the filter takes the first alone, that one alone.
template <class F, int N>
void read_cache(const KeyCache<F, N>& cache, int column, int row, KeyPixel<F> (&pixel)[N][N]) {
  if (F::kFilter == KeyFilter::kNearest) {
    const int bank = N * (row & (N - 1)) + (column & (N - 1));
    pixel[0][0] = cache.bank[bank][bank_address<N>(column, row)];
    return;
  }
BankRows:
  for (int j = 0; j < N; ++j) {
    HS_UNROLL
  BankColumns:
    for (int i = 0; i < N; ++i) {
      HS_UNROLL
      const int x = column + ((i - column) & (N - 1)), y = row + ((j - row) & (N - 1));
      pixel[j][i] = cache.bank[N * j + i][bank_address<N>(x, y)];
    }
  }
  // By a constant or not at all for each bit: of two, and not of N × N.
Bits:
  for (int by = 1; by < N; by *= 2) {
    HS_UNROLL
    if (column & by) rotate(pixel, by, 0);
    if (row & by) rotate(pixel, 0, by);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_KEY_CACHE_HPP_
