// SPDX-License-Identifier: Apache-2.0
// The pixels of stamps, one after the other, with the faces that they show: as the key memory takes them, or the film
// buffer. Indices are given anew in every pass; a table tells the face of an index.
//
// Interval: a cycle a pixel of the frame.
#ifndef HALFSPACE_HLS_MOTION_PIXEL_STORE_HPP_
#define HALFSPACE_HLS_MOTION_PIXEL_STORE_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/scan_pixels.hpp"

namespace halfspace {

// Stores what face a triangle is of, one a call.
template <class F>
bool store_face(Stream<Triangle<F>>& triangle, FaceTable<F>& table) {
  const Triangle<F> in = triangle.read();
  if (!is_zero(in.index)) table.face[int(raw(in.index)) - 1] = in.face;
  return is_set(in.last);
}

// The first lane from `from` on that lies in the frame; F::kLanes if there is none. Lane 0 of a stamp does.
template <class F>
int lane_inside(const Frame<F>& frame, const Scan<F>& in, int from) {
  int first = F::kLanes;
Lanes:
  for (int l = F::kLanes - 1; l >= 0; --l) {
    HS_UNROLL
    const PixelPlace at = lane_place(in, l);
    if (l >= from && at.x < int(raw(frame.width)) && at.y < int(raw(frame.height))) first = l;
  }
  return first;
}

// Sends the pixel of a lane. Returns the lane that is next.
template <class F>
int send_pixel(const Frame<F>& frame, const Scan<F>& in, const Pixel<F>& pixel, int lane, const FaceTable<F>& table,
               Stream<ShownPixel<F>>& shown) {
  const int next = lane_inside(frame, in, lane + 1);
  const PixelPlace at = lane_place(in, lane);
  const bool shows_one = is_set(in.index[lane]);
  ShownPixel<F> out;
  out.last = from_raw<Bit>(is_set(in.last) && next == F::kLanes);
  out.x = from_raw<typename F::X>(at.x);
  out.y = from_raw<typename F::Y>(at.y);
  out.shown = from_raw<Bit>(shows_one);
  out.face = from_raw<typename F::Face>(0);
  if (shows_one) out.face = table.face[int(raw(in.index[lane])) - 1];
  out.r = pixel.r[lane];
  out.g = pixel.g[lane];
  out.b = pixel.b[lane];
  shown.write(out);
  return next;
}

// A stamp, and its colours.
template <class F>
bool pixel_store(const Frame<F>& frame, Stream<Scan<F>>& scan, Stream<Pixel<F>>& pixel, const FaceTable<F>& table,
                 Stream<ShownPixel<F>>& shown) {
  const Scan<F> in = scan.read();
  const Pixel<F> colours = pixel.read();
  int lane = 0;
Pixels:
  for (int n = 0; n < F::kLanes && lane != F::kLanes; ++n) {
    HS_PIPELINE(1)
    lane = send_pixel(frame, in, colours, lane, table, shown);
  }
  return is_set(in.last);
}

// All stamps. A turn takes a pixel: the first of a stamp reads it.
template <class F>
void pixel_store_frame(const Frame<F>& frame, Stream<Scan<F>>& scan, Stream<Pixel<F>>& pixel, const FaceTable<F>& table,
                       Stream<ShownPixel<F>>& shown) {
  Scan<F> in{};
  Pixel<F> colours{};
  int lane = F::kLanes;
  bool done = false;
Turns:
  while (!done) {
    HS_PIPELINE(1)
    if (lane == F::kLanes) {
      in = scan.read();
      colours = pixel.read();
      lane = 0;
    }
    lane = send_pixel(frame, in, colours, lane, table, shown);
    done = lane == F::kLanes && is_set(in.last);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_MOTION_PIXEL_STORE_HPP_
