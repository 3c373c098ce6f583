// SPDX-License-Identifier: Apache-2.0
// The plane-equation Gouraud shader at scan-out (dual pipeline): colour = floor(C + A·x + B·y), C with its ½.
//
// A stamp shows few triangles, mostly one. A cycle shades all lanes of one triangle: one entry is read from TdbS, one
// set of six multipliers gives the planes at the first pixel of the stamp, and an addition a lane the rest. Background
// lanes count as a triangle of their own. Cycles of a stamp: the number of different indices in it. A flat triangle has
// its one colour in TdbS and takes no multiplier.
#ifndef HALFSPACE_HLS_SHADE_SHADE_GOURAUD_HPP_
#define HALFSPACE_HLS_SHADE_SHADE_GOURAUD_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"

namespace halfspace {

// Stores what shade_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<Planes<F>>& planes, ShadingDatabase<F>& database) {
  const Planes<F> in = planes.read();
  if (!raw(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}

// The colour of a flat triangle in the lanes that `shade` names.
template <class F>
void flat_lanes(const typename F::ColourPlane& value, const Bit (&shade)[F::kLanes],
                typename F::Colour (&colour)[F::kLanes]) {
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    colour[l] = from_raw<typename F::Colour>(raw(shade[l]) ? raw(value) : raw(colour[l]));
  }
}

template <class F>
bool shade_gouraud(const Frame<F>& frame, Stream<Scan<F>>& scan, const ShadingDatabase<F>& database,
                   Stream<Pixel<F>>& pixel) {
  const Scan<F> in = scan.read();
  const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
  Pixel<F> out;
  out.last = in.last;
  out.x = in.x;
  out.y = in.y;
  Bit waits[F::kLanes];
Background:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    waits[l] = from_raw<Bit>(raw(in.index[l]) != 0);
    out.r[l] = from_raw<typename F::Colour>(raw(frame.r));
    out.g[l] = from_raw<typename F::Colour>(raw(frame.g));
    out.b[l] = from_raw<typename F::Colour>(raw(frame.b));
  }
Triangles:
  for (int n = 0; n < F::kLanes; ++n) {
    HS_PIPELINE(1)
    Bit shade[F::kLanes];
    const int index = next_group<F>(in.index, waits, shade);
    if (index == 0) break;
    const Planes<F>& planes = database.planes[index - 1];
    if (F::kGouraud) {
      plane_lanes<F>(planes.r, planes.r_dx, planes.r_dy, x, y, shade, out.r);
      plane_lanes<F>(planes.g, planes.g_dx, planes.g_dy, x, y, shade, out.g);
      plane_lanes<F>(planes.b, planes.b_dx, planes.b_dy, x, y, shade, out.b);
    } else {
      flat_lanes<F>(planes.r, shade, out.r);
      flat_lanes<F>(planes.g, shade, out.g);
      flat_lanes<F>(planes.b, shade, out.b);
    }
  }
  pixel.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SHADE_GOURAUD_HPP_
