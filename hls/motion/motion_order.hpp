// SPDX-License-Identifier: Apache-2.0
// The motion buffer: words of motion go in as the scan finds their pixels, by stamps, and come out by tiles of the key
// frames, row by row of tiles and row by row inside one, so that what a cache of a key frame has fetched is used whole.
//
// Words of face 0 are not kept. The last word that comes out says so: one is held back until another is found. Of a
// frame without any comes one of face 0.
//
// Interval: a word a cycle in; then a cycle a pixel of the frame, and one for the last word.
#ifndef HALFSPACE_HLS_MOTION_MOTION_ORDER_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_ORDER_HPP_

#include "hls/motion/film_memories.hpp"

namespace halfspace {

// Stores a word. Returns whether it was the last of the frame.
template <class F>
bool store_motion(Stream<Motion<F>>& motion, MotionBuffer<F>& buffer) {
  const Motion<F> in = motion.read();
  if (is_set(in.face)) buffer.word[pixel_address<F>(int(raw(in.x)), int(raw(in.y)))] = in;
  return is_set(in.last);
}

// The next pixel of a frame in the order of tiles.
struct TilePlace {
  int x = 0, y = 0;
};
inline TilePlace next_in_tiles(const TilePlace& at, int width, int height) {
  const int first_x = at.x & ~(kKeyTile - 1), first_y = at.y & ~(kKeyTile - 1);
  const bool row_ends = (at.x & (kKeyTile - 1)) == kKeyTile - 1 || at.x + 1 == width;
  const bool tile_ends = row_ends && ((at.y & (kKeyTile - 1)) == kKeyTile - 1 || at.y + 1 == height);
  const bool tiles_end = tile_ends && at.x + 1 == width;
  TilePlace next;
  next.x = tiles_end ? 0 : tile_ends || !row_ends ? at.x + 1 : first_x;
  next.y = tiles_end ? at.y + 1 : tile_ends ? first_y : row_ends ? at.y + 1 : at.y;
  return next;
}

// Sends what is stored, and leaves nothing.
template <class F>
void motion_order(const Frame<F>& frame, MotionBuffer<F>& buffer, Stream<Motion<F>>& ordered) {
  const int width = int(raw(frame.width)), height = int(raw(frame.height));
  const Motion<F> none{};
  Motion<F> held = none;
  TilePlace at;
Pixels:
  for (int n = 0; n < frame_words<F>() && at.y < height; ++n) {
    HS_PIPELINE(1)
    const int address = pixel_address<F>(at.x, at.y);
    const Motion<F> in = buffer.word[address];
    if (is_set(in.face)) {
      if (is_set(held.face)) ordered.write(held);
      held = in;
      held.last = from_raw<Bit>(0);
      buffer.word[address] = none;
    }
    at = next_in_tiles(at, width, height);
  }
  held.last = from_raw<Bit>(1);
  ordered.write(held);
}

// A frame: its words in, and out.
template <class F>
void motion_order_frame(const Frame<F>& frame, Stream<Motion<F>>& motion, MotionBuffer<F>& buffer,
                        Stream<Motion<F>>& ordered) {
  bool stored = false;
Words:
  while (!stored) {
    HS_PIPELINE(1)
    stored = store_motion(motion, buffer);
  }
  motion_order(frame, buffer, ordered);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_ORDER_HPP_
