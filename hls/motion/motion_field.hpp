// SPDX-License-Identifier: Apache-2.0
// The motion field at scan-out (index rendering): for each covered pixel of a frame in between its face, and the way
// from its centre to the place of the same point in each key frame.
//
//   perspective   u = s/q,  q·2^k/2^(b−1) = m in [1, 2),  1/m ≈ y: u = (s·2^k)·y / 2^(b−1)      affine   u = s/2^b
//   vector        floor(u_x·2^(e+f) + ½)·2^−f + origin_x − (x + ½),  y alike
//
// s, t, q are the planes at the pixel, rounded to whole numbers. The product with the reciprocal is kept whole, so that
// the place is rounded once, half up; origin, pixel and ½ are multiples of 2^−f and add nothing. A vector that does not
// fit its format is no vector: cut off it would lead to another point. With F::kRelights the planes of colour
// differences are rounded at the pixel as well. The error is derived in docs/numerics.md.
//
// One pixel after the other goes through one set of planes. Multipliers of the RTL, for each key: two for each plane,
// and with perspective one in the reciprocal and two with it.
//
// Interval: a cycle a covered lane; one for a stamp of background.
#ifndef HALFSPACE_HLS_MOTION_MOTION_FIELD_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_FIELD_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/formats/scan_pixels.hpp"
#include "hls/texture/reciprocal_lookup.hpp"

namespace halfspace {

// Stores what motion_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<MotionPlanes<F>>& planes, MotionDatabase<F>& database) {
  const MotionPlanes<F> in = planes.read();
  if (!is_set(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}

// Along an axis, in units of 2^−f pixels. The way from a pixel's centre: origin less pixel has a bit more than a
// position before the point, and the sum with the offset of the place one more. Twice that offset: with u < 2, as s <=
// q + 1, it is below 2^(e+f+2), and e is the bits of a position before the point at most; planes that no triangle has
// may give a bit more.
template <class F>
using Way = Wider<Refined<typename F::Origin, typename F::Vector>, 2>;
template <class F>
using TwiceOffset = Wider<Refined<typename F::Origin::Unsigned, typename F::Vector>, 3>;

// floor(u·2^(e+f) + ½)·2^−f + origin − (pixel + ½), of u = scaled · 2^−(bits of it − head).
template <class F, class Scaled, class Pixel>
Way<F> way_to(const typename F::Origin& origin, const typename F::Extent& extent, const Scaled& scaled, int head,
              const Pixel& pixel) {
  using Twice = TwiceOffset<F>;
  using Vector = typename F::Vector;
  const int below = F::Origin::width() + 2 - head - int(raw(extent));
  const Twice twice = shift_right(leading<Twice>(scaled), below);
  const Twice offset = slice<Twice>(twice + from_raw<Twice>(1), 1);
  const Vector half = from_raw<Vector>(1 << F::kVectorFraction >> 1);
  return origin - pixel - half + offset;
}

template <class F>
KeyVector<F> key_vector(const KeyPlanes<F>& planes, int x, int y) {
  using Coordinate = typename F::Coordinate;
  using Vector = typename F::Vector;
  KeyVector<F> out{};
  if (!is_set(planes.there)) return out;
  // Rounded: the starts have the ½.
  const Coordinate s = plane_at<F>(planes.start[0], planes.dx[0], planes.dy[0], x, y);
  const Coordinate t = plane_at<F>(planes.start[1], planes.dx[1], planes.dy[1], x, y);
  const auto column = from_raw<typename F::X>(x);
  const auto row = from_raw<typename F::Y>(y);
  Way<F> way_x, way_y;
  if (F::kPerspective) {
    const Coordinate q = plane_at<F>(planes.start[2], planes.dx[2], planes.dy[2], x, y);
    const InverseCoordinate<F> inverse = reciprocal_lookup<F>(q);
    const int k = int(raw(inverse.shift));
    // s <= q + 1 of planes of s <= q, as either is rounded, so s·2^k <= 2^b: b + 1 bits, and the product 45 at most.
    using Octave = Wider<Coordinate, 1>;
    using Scaled = Wider<Octave, kInverseFraction>;
    const Octave of_s = shift_left(Octave(s), k), of_t = shift_left(Octave(t), k);
    way_x = way_to<F>(planes.origin_x, planes.extent, slice<Scaled>(of_s * inverse.inverse, 0), 2, column);
    way_y = way_to<F>(planes.origin_y, planes.extent, slice<Scaled>(of_t * inverse.inverse, 0), 2, row);
  } else {
    way_x = way_to<F>(planes.origin_x, planes.extent, s, 0, column);
    way_y = way_to<F>(planes.origin_y, planes.extent, t, 0, row);
  }
  const Vector vector_x = way_x, vector_y = way_y;
  if (vector_x != way_x || vector_y != way_y) return out;  // they do not fit
  out.there = from_raw<Bit>(1);
  out.x = vector_x;
  out.y = vector_y;
  if (!F::kRelights) return out;
  out.r = plane_at<F>(planes.colour[0], planes.colour_dx[0], planes.colour_dy[0], x, y);
  out.g = plane_at<F>(planes.colour[1], planes.colour_dx[1], planes.colour_dy[1], x, y);
  out.b = plane_at<F>(planes.colour[2], planes.colour_dx[2], planes.colour_dy[2], x, y);
  return out;
}

// The word of a pixel that shows a triangle, but for `last`: of state and pixel alone.
template <class F>
Motion<F> motion_pixel(const MotionPlanes<F>& planes, int x, int y) {
  Motion<F> out;
  out.last = from_raw<Bit>(0);
  out.x = from_raw<typename F::X>(x);
  out.y = from_raw<typename F::Y>(y);
  out.face = planes.face;
  static_assert(kKeys == 2, "one after the other: of a loop Bambu makes memories");
  out.key[0] = key_vector<F>(planes.key[0], x, y);
  out.key[1] = key_vector<F>(planes.key[1], x, y);
  return out;
}

// The word of lane l of a stamp, but for `last`; of face 0 if the lane shows none.
template <class F>
Motion<F> motion_lane(const Scan<F>& in, int l, const MotionDatabase<F>& database) {
  const PixelPlace at = lane_place(in, l);
  if (is_set(in.index[l])) return motion_pixel<F>(database.planes[int(raw(in.index[l])) - 1], at.x, at.y);
  Motion<F> out{};
  out.x = from_raw<typename F::X>(at.x);
  out.y = from_raw<typename F::Y>(at.y);
  return out;
}

// Sends the word of a lane, or of a stamp without one (F::kLanes) that of lane 0 if it ends the frame. Returns the lane
// that is next.
template <class F>
int send_lane(const Scan<F>& in, int lane, const MotionDatabase<F>& database, Stream<Motion<F>>& motion) {
  const bool covered = lane < F::kLanes;
  const int next = covered ? covered_lane(in, lane + 1) : F::kLanes;
  const bool last = is_set(in.last) && next == F::kLanes;
  if (covered || last) {
    Motion<F> out = motion_lane(in, covered ? lane : 0, database);
    out.last = from_raw<Bit>(last);
    motion.write(out);
  }
  return next;
}

// One stamp: a word for each lane that shows a triangle, lanes in order; for the last stamp of the frame, if none does,
// a word of face 0.
template <class F>
bool motion_field(Stream<Scan<F>>& scan, const MotionDatabase<F>& database, Stream<Motion<F>>& motion) {
  const Scan<F> in = scan.read();
  int lane = covered_lane(in, 0);
Pixels:
  for (int n = 0; n < F::kLanes; ++n) {
    HS_PIPELINE(1)
    lane = send_lane(in, lane, database, motion);
    if (lane == F::kLanes) break;
  }
  return is_set(in.last);
}

// All stamps. A turn takes a covered lane, or a stamp without one, which it reads first.
template <class F>
void motion_field_frame(Stream<Scan<F>>& scan, const MotionDatabase<F>& database, Stream<Motion<F>>& motion) {
  Scan<F> in{};
  int lane = F::kLanes;
  bool done = false;
Turns:
  while (!done) {
    HS_PIPELINE(1)
    if (lane == F::kLanes) {
      in = scan.read();
      lane = covered_lane(in, 0);
    }
    lane = send_lane(in, lane, database, motion);
    done = lane == F::kLanes && is_set(in.last);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_FIELD_HPP_
