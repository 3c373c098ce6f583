// SPDX-License-Identifier: Apache-2.0
// The memories of a film: the motion of a frame in between, two key frames, and what of a frame in between is found.
// With F::kUpConverts; N = key_side(F::kFilter). A pixel has the same address in frames of any size.
#ifndef HALFSPACE_HLS_MOTION_FILM_MEMORIES_HPP_
#define HALFSPACE_HLS_MOTION_FILM_MEMORIES_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/motion/key_cache.hpp"

namespace halfspace {

// Of a pixel, row by row.
template <class F>
int pixel_address(int x, int y) {
  return y * F::kWidth + x;
}
template <class F>
constexpr int frame_words() {
  return F::kUpConverts ? F::kWidth * F::kHeight : 1;
}

// A word of `motion` a pixel; of face 0: none. So are all before the first frame, and after each.
template <class F>
struct MotionBuffer {
  Motion<F> word[frame_words<F>()];
};

// A pixel of a frame in between whose colour is known; so are none before the first frame, and after each.
template <class F>
struct FoundPixel {
  typename F::Bit shown;
  typename F::Colour r, g, b;
};
template <class F>
struct FilmBuffer {
  FoundPixel<F> pixel[frame_words<F>()];
};

// Key frame k is in slot k modulo 2. N × N banks, by column and row modulo N; a block of a tile is in all of them at
// one address, and the blocks of a tile follow each other.
constexpr int kKeySlots = 2;
template <class F>
constexpr int key_tiles_x() {
  return (F::kWidth + kKeyTile - 1) / kKeyTile;
}
template <class F>
constexpr int key_tiles() {
  return key_tiles_x<F>() * ((F::kHeight + kKeyTile - 1) / kKeyTile);
}
template <class F, int N>
constexpr int key_slot_words() {
  return F::kUpConverts ? key_tiles<F>() * blocks_a_tile(N) : 1;
}
template <class F, int N>
struct KeyFrames {
  KeyPixel<F> bank[N * N][kKeySlots * key_slot_words<F, N>()];
};
template <class F, int N>
int key_tile_address(int slot, int tile_x, int tile_y) {
  return slot * key_slot_words<F, N>() + (tile_y * key_tiles_x<F>() + tile_x) * blocks_a_tile(N);
}
template <class F, int N>
KeyPixel<F>& key_pixel_at(KeyFrames<F, N>& keys, int slot, int x, int y) {
  const int tile = key_tile_address<F, N>(slot, x / kKeyTile, y / kKeyTile);
  const int block = y % kKeyTile / N * blocks_a_row(N) + x % kKeyTile / N;
  return keys.bank[y % N * N + x % N][tile + block];
}

// A key frame as motion_compensate asks it; who watches hears both ways.
template <class F, int N>
struct KeyReader {
  KeyFrames<F, N>& keys;
  int slot;
  Fetch<KeyRequest<F>>& requests;
  Fetch<KeyBlock<F, N>>& blocks;
  int at = 0;

  KeyReader(KeyFrames<F, N>& frames, int of_slot, Fetch<KeyRequest<F>>& asked, Fetch<KeyBlock<F, N>>& answered)
      : keys(frames), slot(of_slot), requests(asked), blocks(answered) {}

  void request(const KeyRequest<F>& tile) {
    requests.write(tile);
    at = key_tile_address<F, N>(slot, int(raw(tile.tile_x)), int(raw(tile.tile_y)));
  }
  KeyBlock<F, N> read() {
    KeyBlock<F, N> out;
  Banks:
    for (int bank = 0; bank < N * N; ++bank) {
      HS_UNROLL
      const KeyPixel<F>& pixel = keys.bank[bank][at];
      out.r[bank] = pixel.r;
      out.g[bank] = pixel.g;
      out.b[bank] = pixel.b;
      out.face[bank] = pixel.face;
    }
    ++at;
    blocks.write(out);
    return out;
  }
};

// What becomes of a word of `shown`: a pixel of the key frame in `slot`; or, in a pass that fills holes, of the frame
// in between, if it shows a triangle.
template <class F, int N>
void store_key(const ShownPixel<F>& in, int slot, KeyFrames<F, N>& keys) {
  KeyPixel<F>& out = key_pixel_at(keys, slot, int(raw(in.x)), int(raw(in.y)));
  out.r = in.r;
  out.g = in.g;
  out.b = in.b;
  out.face = in.face;
}
template <class F>
void store_filled(const ShownPixel<F>& in, FilmBuffer<F>& film) {
  if (!is_set(in.shown)) return;
  FoundPixel<F>& out = film.pixel[pixel_address<F>(int(raw(in.x)), int(raw(in.y)))];
  out.shown = from_raw<Bit>(1);
  out.r = in.r;
  out.g = in.g;
  out.b = in.b;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_FILM_MEMORIES_HPP_
