// SPDX-License-Identifier: Apache-2.0
// The memories of a film: the motion of a frame in between, two key frames, and what of a frame in between is found.
// With F::kUpConverts; N = key_side(F::kFilter). A pixel has the same address in frames of any size.
#ifndef HALFSPACE_HLS_MOTION_FILM_MEMORIES_HPP_
#define HALFSPACE_HLS_MOTION_FILM_MEMORIES_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/motion/key_cache.hpp"

#ifdef HS_WORDS
#define HS_FILM_MEMORY(Record, member, words) Words<Record> member
#define HS_FILM_ROWS(Record, member, rows, words) WordRows<Record, words> member
#else
#define HS_FILM_MEMORY(Record, member, words) Record member[words]
#define HS_FILM_ROWS(Record, member, rows, words) Record member[rows][words]
#endif

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
  HS_FILM_MEMORY(Motion<F>, word, frame_words<F>());
};

// A pixel of a frame in between whose colour is known; so are none before the first frame, and after each.
template <class F>
struct FoundPixel {
  typename F::Bit shown;
  typename F::Colour r, g, b;

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("shown", shown), v("r", r), v("g", g), v("b", b);
  }
};
template <class F>
struct FilmBuffer {
  HS_FILM_MEMORY(FoundPixel<F>, pixel, frame_words<F>());
};

// Key frame k is in slot k modulo 2. N × N banks, by column and row modulo N; a block of a tile is in all of them at
// one address, and the blocks of a tile follow each other.
constexpr int kKeySlots = 2;
template <class F>
constexpr int slot_tiles_x() {
  return (F::kWidth + kKeyTile - 1) / kKeyTile;
}
template <class F>
constexpr int slot_tiles() {
  return slot_tiles_x<F>() * ((F::kHeight + kKeyTile - 1) / kKeyTile);
}
template <class F, int N>
constexpr int key_slot_words() {
  return F::kUpConverts ? slot_tiles<F>() * blocks_a_tile(N) : 1;
}
template <class F, int N>
struct FilmKeys {
  static constexpr int kBankWords = kKeySlots * key_slot_words<F, N>();
  HS_FILM_ROWS(KeyPixel<F>, bank, N* N, kBankWords);
};
template <class F, int N>
int key_tile_address(int slot, int tile_x, int tile_y) {
  return slot * key_slot_words<F, N>() + (tile_y * slot_tiles_x<F>() + tile_x) * blocks_a_tile(N);
}
// Where a pixel is.
template <int N>
int key_bank(int x, int y) {
  return y % N * N + x % N;
}
template <class F, int N>
int key_address(int slot, int x, int y) {
  const int tile = key_tile_address<F, N>(slot, x / kKeyTile, y / kKeyTile);
  return tile + y % kKeyTile / N * blocks_a_row(N) + x % kKeyTile / N;
}

// A key frame as motion_compensate asks it; who watches hears both ways.
template <class F, int N>
struct KeyReader {
  FilmKeys<F, N>& keys;
  int slot;
  Fetch<KeyRequest<F>>& requests;
  Fetch<KeyBlock<F, N>>& blocks;
  int at = 0;

  KeyReader(FilmKeys<F, N>& frames, int of_slot, Fetch<KeyRequest<F>>& asked, Fetch<KeyBlock<F, N>>& answered)
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
      const KeyPixel<F> pixel = keys.bank[bank][at];
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
void store_key(const ShownPixel<F>& in, int slot, FilmKeys<F, N>& keys) {
  const int x = int(raw(in.x)), y = int(raw(in.y));
  KeyPixel<F> pixel;
  pixel.r = in.r;
  pixel.g = in.g;
  pixel.b = in.b;
  pixel.face = in.face;
  keys.bank[key_bank<N>(x, y)][key_address<F, N>(slot, x, y)] = pixel;
}
template <class F>
void store_found(int x, int y, const typename F::Colour& r, const typename F::Colour& g, const typename F::Colour& b,
                 FilmBuffer<F>& film) {
  FoundPixel<F> pixel;
  pixel.shown = from_raw<Bit>(1);
  pixel.r = r;
  pixel.g = g;
  pixel.b = b;
  film.pixel[pixel_address<F>(x, y)] = pixel;
}
template <class F>
void store_filled(const ShownPixel<F>& in, FilmBuffer<F>& film) {
  if (is_set(in.shown)) store_found<F>(int(raw(in.x)), int(raw(in.y)), in.r, in.g, in.b, film);
}

#undef HS_FILM_MEMORY
#undef HS_FILM_ROWS

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_FILM_MEMORIES_HPP_
