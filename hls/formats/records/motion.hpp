// SPDX-License-Identifier: Apache-2.0
// The records of room motion that the pipeline has; those of motion_compensate are in hls/formats/key_records.hpp.
#ifndef HALFSPACE_HLS_FORMATS_RECORDS_MOTION_HPP_
#define HALFSPACE_HLS_FORMATS_RECORDS_MOTION_HPP_

#include "hls/formats/records/frame.hpp"

namespace halfspace {

// The key frames: the one before a frame in between, and the one after it.
constexpr int kKeys = 2;

// Where a triangle of a frame in between is in a key frame. With a place (x, y) less the origin, u = (place −
// origin)/2^e in [0, 1]², and W = w of a vertex at the key over its w in between, for its vertices in the order given:
//
//   perspective   q = (2^b − 1)·W/W_most, rounded, 1 at least;  s = q·u_x,  t = q·u_y, rounded
//   affine        s = 2^b·u_x,  t = 2^b·u_y, rounded, 2^b − 1 at most
template <class F>
struct KeyPlaces {
  typename F::Bit there;  // the triangle has a place in the key frame; else the rest means nothing
  typename F::Origin origin_x, origin_y;
  typename F::Extent extent;  // e
  typename F::Coordinate s[3], t[3], q[3];
  typename F::Difference r[3], g[3],
      b[3];  // F::kRelights: colour in between less that at the key, plus 2^c, in units of 2^−d
};

// geometry → motion_setup, with F::kHasMotion, in answer to a Visible that says so.
template <class F>
struct MotionVectors {
  typename F::Bit last;
  typename F::Index index;
  typename F::Face face;
  KeyPlaces<F> key[kKeys];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("index", index), v("face", face);
    visit_key(v, key[0], kNames[0]);
    visit_key(v, key[1], kNames[1]);
  }

 private:
  using Names = const char* const[22];
  static constexpr Names kNames[kKeys] = {
      {"there_0", "origin_x_0", "origin_y_0", "extent_0", "s0_0", "s1_0", "s2_0", "t0_0", "t1_0", "t2_0", "q0_0",
       "q1_0",    "q2_0",       "r0_0",       "r1_0",     "r2_0", "g0_0", "g1_0", "g2_0", "b0_0", "b1_0", "b2_0"},
      {"there_1", "origin_x_1", "origin_y_1", "extent_1", "s0_1", "s1_1", "s2_1", "t0_1", "t1_1", "t2_1", "q0_1",
       "q1_1",    "q2_1",       "r0_1",       "r1_1",     "r2_1", "g0_1", "g1_1", "g2_1", "b0_1", "b1_1", "b2_1"}};
  template <class V>
  HS_INLINE static constexpr void visit_key(V&& v, KeyPlaces<F>& k, Names& n) {
    v(n[0], k.there), v(n[1], k.origin_x), v(n[2], k.origin_y), v(n[3], k.extent);
    v(n[4], k.s[0]), v(n[5], k.s[1]), v(n[6], k.s[2]);
    v(n[7], k.t[0]), v(n[8], k.t[1]), v(n[9], k.t[2]);
    if (F::kPerspective) v(n[10], k.q[0]), v(n[11], k.q[1]), v(n[12], k.q[2]);
    if (!F::kRelights) return;
    v(n[13], k.r[0]), v(n[14], k.r[1]), v(n[15], k.r[2]);
    v(n[16], k.g[0]), v(n[17], k.g[1]), v(n[18], k.g[2]);
    v(n[19], k.b[0]), v(n[20], k.b[1]), v(n[21], k.b[2]);
  }
};
template <class F>
constexpr typename MotionVectors<F>::Names MotionVectors<F>::kNames[kKeys];

// Planes of the same, each at the centre of pixel (0, 0) of the frame, ½ included.
template <class F>
struct KeyPlanes {
  typename F::Bit there;
  typename F::Origin origin_x, origin_y;
  typename F::Extent extent;
  typename F::CoordinatePlane start[3];  // s, t, q
  typename F::CoordinateGradient dx[3], dy[3];
  typename F::DifferencePlane colour[3];  // r, g, b
  typename F::DifferenceGradient colour_dx[3], colour_dy[3];
};

// motion_setup → TdbS, with F::kHasMotion: the entry of triangle `index`.
template <class F>
struct MotionPlanes {
  typename F::Bit last;
  typename F::Bit empty;  // nothing to store
  typename F::Index index;
  typename F::Face face;
  KeyPlanes<F> key[kKeys];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("empty", empty), v("index", index), v("face", face);
    visit_key(v, key[0], kNames[0]);
    visit_key(v, key[1], kNames[1]);
  }

 private:
  using Names = const char* const[22];
  static constexpr Names kNames[kKeys] = {
      {"there_0", "origin_x_0", "origin_y_0", "extent_0", "s_0",    "s_dx_0", "s_dy_0", "t_0",
       "t_dx_0",  "t_dy_0",     "q_0",        "q_dx_0",   "q_dy_0", "r_0",    "r_dx_0", "r_dy_0",
       "g_0",     "g_dx_0",     "g_dy_0",     "b_0",      "b_dx_0", "b_dy_0"},
      {"there_1", "origin_x_1", "origin_y_1", "extent_1", "s_1",    "s_dx_1", "s_dy_1", "t_1",
       "t_dx_1",  "t_dy_1",     "q_1",        "q_dx_1",   "q_dy_1", "r_1",    "r_dx_1", "r_dy_1",
       "g_1",     "g_dx_1",     "g_dy_1",     "b_1",      "b_dx_1", "b_dy_1"}};
  template <class V>
  HS_INLINE static constexpr void visit_key(V&& v, KeyPlanes<F>& k, Names& n) {
    v(n[0], k.there), v(n[1], k.origin_x), v(n[2], k.origin_y), v(n[3], k.extent);
    v(n[4], k.start[0]), v(n[5], k.dx[0]), v(n[6], k.dy[0]);
    v(n[7], k.start[1]), v(n[8], k.dx[1]), v(n[9], k.dy[1]);
    if (F::kPerspective) v(n[10], k.start[2]), v(n[11], k.dx[2]), v(n[12], k.dy[2]);
    if (!F::kRelights) return;
    v(n[13], k.colour[0]), v(n[14], k.colour_dx[0]), v(n[15], k.colour_dy[0]);
    v(n[16], k.colour[1]), v(n[17], k.colour_dx[1]), v(n[18], k.colour_dy[1]);
    v(n[19], k.colour[2]), v(n[20], k.colour_dx[2]), v(n[21], k.colour_dy[2]);
  }
};
template <class F>
constexpr typename MotionPlanes<F>::Names MotionPlanes<F>::kNames[kKeys];

// A pixel of the motion buffer, in pixels of the frame in between: the face that it shows, and for each key frame the
// way from its centre to the place of the same point there.
template <class F>
struct KeyVector {
  typename F::Bit there;  // 0: the point has no place in the key frame, or the vector does not fit, and is 0
  typename F::Vector x, y;
  typename F::Difference r, g, b;  // F::kRelights: colour in between less that at the key, plus 2^c, in units of 2^−d
};

// motion_field → motion buffer → motion_compensate: a word a covered pixel. A frame whose last stamp covers nothing
// ends with a word of face 0.
template <class F>
struct Motion {
  typename F::Bit last;
  typename F::X x;  // in pixels
  typename F::Y y;
  typename F::Face face;
  KeyVector<F> key[kKeys];

  template <class V>
  HS_INLINE constexpr void visit(V&& v) {
    v("last", last), v("x", x), v("y", y), v("face", face);
    v("there_0", key[0].there), v("vx_0", key[0].x), v("vy_0", key[0].y);
    if (F::kRelights) v("r_0", key[0].r), v("g_0", key[0].g), v("b_0", key[0].b);
    v("there_1", key[1].there), v("vx_1", key[1].x), v("vy_1", key[1].y);
    if (F::kRelights) v("r_1", key[1].r), v("g_1", key[1].g), v("b_1", key[1].b);
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_RECORDS_MOTION_HPP_
