// SPDX-License-Identifier: Apache-2.0
// Where a frame in between has no colour from the key frames though it shows a face: a hole. Its pixel is marked, and
// its face asked for, so that the triangles of faces with holes alone are shaded. Neighbours mostly show one face: it
// is asked for once for as long as no hole of another comes.
//
// A face is held back until another comes, so that the last word of the frame is known; of a frame without holes it is
// one of face 0. What has a colour goes into the film buffer.
//
// Interval: a pixel a cycle; one more for a frame whose last pixel is a hole of another face than the hole before it.
#ifndef HALFSPACE_HLS_MOTION_HOLE_FIND_HPP_
#define HALFSPACE_HLS_MOTION_HOLE_FIND_HPP_

#include "hls/motion/film_memories.hpp"

namespace halfspace {

// Marks a pixel.
template <class F>
void mark_hole(int x, int y, HoleMarks<F>& marks) {
  const auto stamp_x = from_raw<typename F::X>(x >> F::kLog2LanesX);
  const auto stamp_y = from_raw<typename F::Y>(y >> F::kLog2LanesY);
  const int address = stamp_address<F>(stamp_x, stamp_y);
  const int lane = (y & (F::kLanesY - 1)) << F::kLog2LanesX | (x & (F::kLanesX - 1));
  Bit marked[F::kLanes];
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    marked[l] = from_raw<Bit>(l == lane || is_set(Bit(marks.hole[address][l])));
  }
  store_lanes(marks.hole, address, marked);
}

template <class F>
void ask(int last, const typename F::Face& face, Stream<Asked<F>>& asked) {
  Asked<F> word;
  word.last = from_raw<Bit>(last);
  word.face = face;
  asked.write(word);
}

// A pixel: its word of motion, for the face, and what the key frames give. `held` is the face that is asked for next, 0
// before a frame and after it.
template <class F>
bool hole_find(Stream<Motion<F>>& ordered, Stream<Compensated<F>>& compensated, FilmBuffer<F>& film,
               HoleMarks<F>& marks, typename F::Face& held, Stream<Asked<F>>& asked) {
  using Face = typename F::Face;
  const Face face = ordered.read().face;
  const Compensated<F> in = compensated.read();
  const int x = int(raw(in.x)), y = int(raw(in.y));
  if (is_set(in.keys)) {
    store_found<F>(x, y, in.r, in.g, in.b, film);
  } else if (is_set(face)) {
    mark_hole(x, y, marks);
    if (is_set(held) && face != held) ask<F>(0, held, asked);
    held = face;
  }
  if (is_set(in.last)) {
    ask<F>(1, held, asked);
    held = from_raw<Face>(0);
  }
  return is_set(in.last);
}

// A frame.
template <class F>
void hole_find_frame(Stream<Motion<F>>& ordered, Stream<Compensated<F>>& compensated, FilmBuffer<F>& film,
                     HoleMarks<F>& marks, Stream<Asked<F>>& asked) {
  typename F::Face held = from_raw<typename F::Face>(0);
  bool done = false;
Words:
  while (!done) {
    HS_PIPELINE(1)
    done = hole_find(ordered, compensated, film, marks, held, asked);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_HOLE_FIND_HPP_
