// SPDX-License-Identifier: Apache-2.0
// The plane-equation Gouraud shader at scan-out (dual pipeline): colour = floor(C + A·x + B·y), C with its ½.
//
// A stamp shows few triangles, mostly one. A cycle shades all lanes of one triangle: one entry is read from TdbS, one
// set of six multipliers gives the planes at the first pixel of the stamp, and an addition a lane the rest. A flat
// triangle has its one colour in TdbS and takes no multiplier.
//
// Interval: a cycle for each different triangle in a stamp, one for a stamp of background.
#ifndef HALFSPACE_HLS_SHADE_SHADE_GOURAUD_HPP_
#define HALFSPACE_HLS_SHADE_SHADE_GOURAUD_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"

namespace halfspace {

// Stores what shade_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<Planes<F>>& planes, ShadingDatabase<F>& database) {
  const Planes<F> in = planes.read();
  if (!is_set(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}

// The colour of a flat triangle in the lanes of `group`.
template <class F>
void flat_lanes(const typename F::ColourPlane& value, const Bit (&group)[F::kLanes],
                typename F::Colour (&colour)[F::kLanes]) {
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    colour[l] = select(is_set(group[l]), slice<typename F::Colour>(value, 0), colour[l]);
  }
}

// A triangle in the lanes of `group` of a stamp, the first pixel of which is (x, y). What comes out depends on nothing
// else.
template <class F>
void gouraud_lanes(const Planes<F>& planes, const Bit (&group)[F::kLanes], int x, int y, Pixel<F>& pixel) {
  if (F::kGouraud) {
    plane_lanes<F>(planes.r, planes.r_dx, planes.r_dy, x, y, group, pixel.r);
    plane_lanes<F>(planes.g, planes.g_dx, planes.g_dy, x, y, group, pixel.g);
    plane_lanes<F>(planes.b, planes.b_dx, planes.b_dy, x, y, group, pixel.b);
  } else {
    flat_lanes<F>(planes.r, group, pixel.r);
    flat_lanes<F>(planes.g, group, pixel.g);
    flat_lanes<F>(planes.b, group, pixel.b);
  }
}

// A stamp of background, and the lanes that wait for a triangle.
template <class F>
void start_stamp(const Frame<F>& frame, const Scan<F>& in, Pixel<F>& pixel, Bit (&waits)[F::kLanes]) {
  pixel.last = in.last;
  pixel.x = in.x;
  pixel.y = in.y;
Background:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    waits[l] = from_raw<Bit>(is_set(in.index[l]));
    pixel.r[l] = frame.r;
    pixel.g[l] = frame.g;
    pixel.b[l] = frame.b;
  }
}
// The next triangle of the stamp. Returns whether there was one.
template <class F>
bool shade_group(const Scan<F>& in, const ShadingDatabase<F>& database, Pixel<F>& pixel, Bit (&waits)[F::kLanes]) {
  Bit group[F::kLanes];
  const int index = next_group<F>(in.index, waits, group);
  if (index == 0) return false;
  const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
  gouraud_lanes(database.planes[index - 1], group, x, y, pixel);
  return true;
}

template <class F>
bool shade_gouraud(const Frame<F>& frame, Stream<Scan<F>>& scan, const ShadingDatabase<F>& database,
                   Stream<Pixel<F>>& pixel) {
  const Scan<F> in = scan.read();
  Pixel<F> out;
  Bit waits[F::kLanes];
  start_stamp(frame, in, out, waits);
Triangles:
  for (int n = 0; n < F::kLanes; ++n) {
    HS_PIPELINE(1)
    if (!shade_group(in, database, out, waits)) break;
  }
  pixel.write(out);
  return is_set(in.last);
}

// All stamps. A turn takes a triangle: the first of a stamp reads it, and the last writes its pixels.
template <class F>
void shade_gouraud_frame(const Frame<F>& frame, Stream<Scan<F>>& scan, const ShadingDatabase<F>& database,
                         Stream<Pixel<F>>& pixel) {
  Scan<F> in{};
  Pixel<F> out{};
  Bit waits[F::kLanes];
  bool starts = true, done = false;
Turns:
  while (!done) {
    HS_PIPELINE(1)
    if (starts) {
      in = scan.read();
      start_stamp(frame, in, out, waits);
    }
    shade_group(in, database, out, waits);
    starts = !any_waits<F>(waits);
    if (starts) pixel.write(out);
    done = starts && is_set(in.last);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SHADE_GOURAUD_HPP_
