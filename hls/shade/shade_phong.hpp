// SPDX-License-Identifier: Apache-2.0
// Phong shading at scan-out (index rendering, shading type Phong): the normal of a pixel from the planes of its
// triangle, rounded to p bits, then lit. Each visible pixel is lit once, and what is hidden never.
//
// One pixel after the other goes through one set of planes and one lighting core. Cycles of a stamp: its covered lanes
// times the lights, and the lights for a stamp of background.
#ifndef HALFSPACE_HLS_SHADE_SHADE_PHONG_HPP_
#define HALFSPACE_HLS_SHADE_SHADE_PHONG_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/shade/lighting.hpp"

namespace halfspace {

// Stores what phong_setup sends, one entry a call. Returns whether it was the last of the frame.
template <class F>
bool store_planes(Stream<NormalPlanes<F>>& planes, NormalDatabase<F>& database) {
  const NormalPlanes<F> in = planes.read();
  if (!raw(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}

// The component of a normal at pixel (x, y), without the offset that it has in a plane.
template <class F>
typename F::Normal normal_component(const typename F::NormalPlane& start, const typename F::NormalGradient& dx,
                                    const typename F::NormalGradient& dy, int x, int y) {
  const typename F::NormalChannel::Value offset = plane_at<F>(start, dx, dy, x, y);  // rounded: the start has the ½
  return from_raw<typename F::Normal>(std::int64_t(raw(offset)) - (std::int64_t(1) << F::Normal::fraction()));
}

template <class F>
bool shade_phong(const Frame<F>& frame, Stream<Scan<F>>& scan, const NormalDatabase<F>& database,
                 const LightTable<F>& lights, const MaterialTable<F>& materials, Stream<Pixel<F>>& pixel) {
  const Scan<F> in = scan.read();
  const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
  Pixel<F> out;
  out.last = in.last;
  out.x = in.x;
  out.y = in.y;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_PIPELINE(1)
    out.r[l] = from_raw<typename F::Colour>(raw(frame.r));
    out.g[l] = from_raw<typename F::Colour>(raw(frame.g));
    out.b[l] = from_raw<typename F::Colour>(raw(frame.b));
    if (raw(in.index[l]) == 0) continue;
    const NormalPlanes<F>& planes = database.planes[int(raw(in.index[l])) - 1];
    typename F::Normal normal[3];
  Components:
    for (int i = 0; i < 3; ++i) {
      HS_UNROLL
      normal[i] =
          normal_component<F>(planes.start[i], planes.dx[i], planes.dy[i], x + l % F::kLanesX, y + l / F::kLanesX);
    }
    const Rgb<F> colour = light_normal<F>(normal, planes.material, lights, materials);
    out.r[l] = colour.channel[0];
    out.g[l] = colour.channel[1];
    out.b[l] = colour.channel[2];
  }
  pixel.write(out);
  return is_set(in.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SHADE_PHONG_HPP_
