// SPDX-License-Identifier: Apache-2.0
// The film comes out: a frame that is in a slot of the key memory, or one in between from the film buffer. A pixel of
// that which neither a key shows nor a triangle is the background; the buffer is cleared on the way.
//
// Interval: a pixel a cycle.
#ifndef HALFSPACE_HLS_MOTION_FILM_SCAN_HPP_
#define HALFSPACE_HLS_MOTION_FILM_SCAN_HPP_

#include "hls/motion/film_memories.hpp"

namespace halfspace {

// Of pixel (x, y), but for its colour.
template <class F>
FilmPixel<F> film_place(const Frame<F>& frame, int x, int y) {
  FilmPixel<F> out;
  out.last = from_raw<Bit>(x + 1 == int(raw(frame.width)) && y + 1 == int(raw(frame.height)));
  out.x = from_raw<typename F::X>(x);
  out.y = from_raw<typename F::Y>(y);
  return out;
}

// Of a key frame.
template <class F, int N>
FilmPixel<F> key_film_pixel(const Frame<F>& frame, FilmKeys<F, N>& keys, int slot, int x, int y) {
  FilmPixel<F> out = film_place(frame, x, y);
  const KeyPixel<F> in = keys.bank[key_bank<N>(x, y)][key_address<F, N>(slot, x, y)];
  out.r = in.r;
  out.g = in.g;
  out.b = in.b;
  return out;
}
// Of a frame in between.
template <class F>
FilmPixel<F> found_film_pixel(const Frame<F>& frame, FilmBuffer<F>& film, int x, int y) {
  FilmPixel<F> out = film_place(frame, x, y);
  const int address = pixel_address<F>(x, y);
  const FoundPixel<F> in = film.pixel[address], none{};
  const bool shown = is_set(in.shown);
  out.r = select(shown, in.r, frame.r);
  out.g = select(shown, in.g, frame.g);
  out.b = select(shown, in.b, frame.b);
  film.pixel[address] = none;
  return out;
}

// A frame: that of the key in `slot`, or what is found in between.
template <class F, int N>
void film_scan(const Frame<F>& frame, bool of_key, int slot, FilmKeys<F, N>& keys, FilmBuffer<F>& film,
               Stream<FilmPixel<F>>& out) {
Rows:
  for (int y = 0; y < int(raw(frame.height)); ++y) {
  Pixels:
    for (int x = 0; x < int(raw(frame.width)); ++x) {
      HS_PIPELINE(1)
      out.write(of_key ? key_film_pixel(frame, keys, slot, x, y) : found_film_pixel(frame, film, x, y));
    }
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_FILM_SCAN_HPP_
