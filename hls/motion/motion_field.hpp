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
// One pixel after the other goes through one set of planes. Cycles of a stamp in the RTL: its covered lanes, one at
// least. Multipliers there, for each key: two for each plane, and with perspective one in the reciprocal and two with
// it.
#ifndef HALFSPACE_HLS_MOTION_MOTION_FIELD_HPP_
#define HALFSPACE_HLS_MOTION_MOTION_FIELD_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/texture/reciprocal_lookup.hpp"

namespace halfspace {

// Stores what motion_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<MotionPlanes<F>>& planes, MotionDatabase<F>& database) {
  const MotionPlanes<F> in = planes.read();
  if (!raw(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}

// floor(u·2^(e+f) + ½) of u = scaled·2^−point: with u < 2, as s <= q + 1, below 2^(range_bits + f + 1), 29 bits. A left
// shift is one of affine places alone, where scaled < 2^point: to e + f + 1 <= 29 bits.
inline std::int64_t place_offset(std::uint64_t scaled, int point, int places) {
  const int left = places + 1 - point;
  const std::uint64_t twice = left > 0 ? scaled << left : scaled >> -left;
  return std::int64_t((twice + 1) >> 1);
}

// From the centre of pixel `pixel` along an axis, in units of 2^−f: origin less pixel has a bit more than a position
// before the point, and the sum with the offset one more, 30 bits and a sign.
template <class F>
std::int64_t way_to(const typename F::Origin& origin, std::int64_t offset, int pixel) {
  const int f = F::kVectorFraction;
  const std::int64_t whole = std::int64_t(raw(origin)) - pixel;
  return whole * (std::int64_t(1) << f) - (std::int64_t(1) << (f - 1)) + offset;
}

template <class F>
bool vector_fits(std::int64_t way) {
  const std::int64_t end = std::int64_t(1) << (F::kVectorRange + F::kVectorFraction);
  return way >= -end && way < end;
}

template <class F>
KeyVector<F> key_vector(const KeyPlanes<F>& planes, int x, int y) {
  using Coordinate = typename F::Coordinate;
  KeyVector<F> out{};
  if (!raw(planes.there)) return out;
  // Rounded: the starts have the ½.
  const Coordinate s = plane_at<F>(planes.start[0], planes.dx[0], planes.dy[0], x, y);
  const Coordinate t = plane_at<F>(planes.start[1], planes.dx[1], planes.dy[1], x, y);
  std::uint64_t u = raw(s), v = raw(t);
  int point = Coordinate::width();
  if (F::kPerspective) {
    const Coordinate q = plane_at<F>(planes.start[2], planes.dx[2], planes.dy[2], x, y);
    const InverseCoordinate<F> inverse = reciprocal_lookup<F>(q);
    const int k = int(raw(inverse.shift));
    const std::uint64_t by = raw(inverse.inverse);
    // s <= q + 1 of planes of s <= q, as either is rounded, so s·2^k <= 2^b: b + 1 bits, and the product 45 at most.
    const std::uint64_t mask = (std::uint64_t(1) << (point + 1)) - 1;
    u = (u << k & mask) * by;
    v = (v << k & mask) * by;
    point += kInverseFraction - 1;
  }
  const int places = int(raw(planes.extent)) + F::kVectorFraction;
  const std::int64_t way_x = way_to<F>(planes.origin_x, place_offset(u, point, places), x);
  const std::int64_t way_y = way_to<F>(planes.origin_y, place_offset(v, point, places), y);
  if (!vector_fits<F>(way_x) || !vector_fits<F>(way_y)) return out;
  out.there = from_raw<Bit>(1);
  out.x = from_raw<typename F::Vector>(way_x);
  out.y = from_raw<typename F::Vector>(way_y);
  if (!F::kRelights) return out;
  out.r = plane_at<F>(planes.colour[0], planes.colour_dx[0], planes.colour_dy[0], x, y);
  out.g = plane_at<F>(planes.colour[1], planes.colour_dx[1], planes.colour_dy[1], x, y);
  out.b = plane_at<F>(planes.colour[2], planes.colour_dx[2], planes.colour_dy[2], x, y);
  return out;
}

// One stamp: a word for each lane that shows a triangle, lanes in order; for the last stamp of the frame, if none does,
// a word of face 0.
template <class F>
bool motion_field(Stream<Scan<F>>& scan, const MotionDatabase<F>& database, Stream<Motion<F>>& motion) {
  const Scan<F> in = scan.read();
  const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
  int end = 0;  // behind the last lane that sends a word
Covered:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    if (raw(in.index[l]) != 0) end = l + 1;
  }
  const bool none = end == 0;
  if (none && raw(in.last)) end = 1;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_PIPELINE(1)
    if (l >= end || (!none && raw(in.index[l]) == 0)) continue;
    Motion<F> out{};
    out.last = from_raw<Bit>(raw(in.last) != 0 && l + 1 == end);
    const int pixel_x = x + l % F::kLanesX, pixel_y = y + l / F::kLanesX;
    out.x = from_raw<typename F::X>(pixel_x);
    out.y = from_raw<typename F::Y>(pixel_y);
    if (!none) {
      const MotionPlanes<F>& planes = database.planes[int(raw(in.index[l])) - 1];
      out.face = planes.face;
    Keys:
      for (int k = 0; k < kKeys; ++k) out.key[k] = key_vector<F>(planes.key[k], pixel_x, pixel_y);
    }
    motion.write(out);
  }
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_MOTION_FIELD_HPP_
