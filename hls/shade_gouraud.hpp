// SPDX-License-Identifier: Apache-2.0
// The plane-equation Gouraud shader at scan-out (dual pipeline): colour = floor(C + A·x + B·y), C with its ½.
//
// A stamp shows few triangles, mostly one. A cycle shades all lanes of one triangle: one entry is read from TdbS, one set
// of six multipliers gives the planes at the first pixel of the stamp, and an addition a lane the rest. Background lanes
// count as a triangle of their own. Cycles of a stamp: the number of different indices in it. A flat triangle has its one
// colour in TdbS and takes no multiplier.
#ifndef HALFSPACE_HLS_SHADE_GOURAUD_HPP_
#define HALFSPACE_HLS_SHADE_GOURAUD_HPP_

#include "buffers.hpp"
#include "stream.hpp"

namespace halfspace {

// Stores what shade_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<Planes<F>>& planes, ShadingDatabase<F>& database) {
  const Planes<F> in = planes.read();
  if (!raw(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return raw(in.last) != 0;
}

// The colours of one plane in the lanes that `shade` names, from pixel (x, y) on.
template <class F>
void shade_lanes(const typename F::ColourPlane& origin, const typename F::ColourGradient& dx,
                 const typename F::ColourGradient& dy, int x, int y, const Bit (&shade)[F::kLanes],
                 typename F::Colour (&colour)[F::kLanes]) {
  using Plane = typename F::ColourPlane;
  const Plane along_x = dx * from_raw<typename F::X>(x);
  const Plane along_y = dy * from_raw<typename F::Y>(y);
  const Plane start_x = origin + along_x;
  const Plane start = start_x + along_y;
  // Unsigned: the planes wrap, and so may these.
  using Word = typename Plane::Carrier;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const Word step = Word(raw(dx)) * Word(l % F::kLanesX) + Word(raw(dy)) * Word(l / F::kLanesX);
    const typename F::Colour rounded = from_raw<Plane>(raw(start) + step);
    colour[l] = from_raw<typename F::Colour>(raw(shade[l]) ? raw(rounded) : raw(colour[l]));
  }
}

// The same of a flat triangle.
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
void shade_gouraud(const Frame<F>& frame, Stream<Scan<F>>& scan, const ShadingDatabase<F>& database,
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
    int first = F::kLanes;  // lane that waits
  Pick:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      const int lane = raw(waits[l]) ? l : F::kLanes;
      first = lane < first ? lane : first;
    }
    if (first == F::kLanes) break;
    const int index = int(raw(in.index[first]));
    Bit shade[F::kLanes];
  Match:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      shade[l] = from_raw<Bit>(int(raw(in.index[l])) == index);
      waits[l] = from_raw<Bit>(raw(waits[l]) & ~raw(shade[l]));
    }
    const Planes<F>& planes = database.planes[index - 1];
    if (F::kGouraud) {
      shade_lanes<F>(planes.r, planes.r_dx, planes.r_dy, x, y, shade, out.r);
      shade_lanes<F>(planes.g, planes.g_dx, planes.g_dy, x, y, shade, out.g);
      shade_lanes<F>(planes.b, planes.b_dx, planes.b_dy, x, y, shade, out.b);
    } else {
      flat_lanes<F>(planes.r, shade, out.r);
      flat_lanes<F>(planes.g, shade, out.g);
      flat_lanes<F>(planes.b, shade, out.b);
    }
  }
  pixel.write(out);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_GOURAUD_HPP_
