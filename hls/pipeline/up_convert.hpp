// SPDX-License-Identifier: Apache-2.0
// A film: key frames that are shaded, and frames between them that are made of these. Which unit feeds which, beside
// the pipeline of triangles (front.hpp, back.hpp), which all passes share.
//
//   key       … pixel ─► pixel_store ─shown─► key memory
//   between   … motion ─► motion_order ─ordered─► motion_compensate ─compensated─► hole_find ─► film buffer, asked
//   fill      … pixel ─► pixel_store ─shown─► film buffer
//
//   key memory, film buffer ─► film_scan ─► film
#ifndef HALFSPACE_HLS_PIPELINE_UP_CONVERT_HPP_
#define HALFSPACE_HLS_PIPELINE_UP_CONVERT_HPP_

#include "hls/motion/film_scan.hpp"
#include "hls/motion/hole_find.hpp"
#include "hls/motion/motion_compensate.hpp"
#include "hls/motion/motion_order.hpp"
#include "hls/pipeline/pipeline.hpp"

namespace halfspace {

template <class F, int N>
struct FilmStreams {
  HS_STREAM_MEMBERS(HS_FILM_STREAMS)
  Stream<Motion<F>> compensated_motion, found_motion;  // copies of ordered
};

template <class F, int N>
struct FilmMemories {
  MotionBuffer<F> motion;
  FilmKeys<F, N> keys;
  FilmBuffer<F> film;
  KeyCache<F, N> cache[kKeys];
};

// Where the number of a key frame is kept.
constexpr int key_slot(int number) { return number % kKeySlots; }

// A word of s.shown into the key memory, as a pixel of key frame `key`; or, where holes are filled, into the film
// buffer.
template <class F, int N>
void film_store(const ShownPixel<F>& shown, Pass pass, int key, FilmMemories<F, N>& m) {
  if (pass == Pass::kKey) store_key<F, N>(shown, key_slot(key), m.keys);
  else store_filled<F>(shown, m.film);
}

// The field, once all of s.motion is stored: `interval` is the number of the key before it.
template <class F, int N>
void film_compensate(const Frame<F>& frame, const typename F::KeyWeight& weight, const KeyWeights<F>& weights,
                     int interval, FilmStreams<F, N>& s, Buffers<F>& b, FilmMemories<F, N>& m) {
  CompensationFrame<F> registers;
  registers.width = frame.width;
  registers.height = frame.height;
  registers.weight = weight;
  KeyReader<F, N> key_0(m.keys, key_slot(interval), s.key_request_0, s.key_block_0);
  KeyReader<F, N> key_1(m.keys, key_slot(interval + 1), s.key_request_1, s.key_block_1);
  empty_cache(m.cache[0]);
  empty_cache(m.cache[1]);
  typename F::Face held = from_raw<typename F::Face>(0);
  motion_order(frame, m.motion, s.ordered);
  bool done = false;
Words:
  while (!done) {
    fork(s.ordered, s.compensated_motion, s.found_motion);
    motion_compensate<F, N>(registers, weights, m.cache[0], m.cache[1], key_0, key_1, s.compensated_motion,
                            s.compensated);
    done = hole_find(s.found_motion, s.compensated, m.film, b.holes, held, s.asked);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_PIPELINE_UP_CONVERT_HPP_
