// SPDX-License-Identifier: Apache-2.0
// Phong shading at scan-out (index rendering, shading type Phong): the normal of a pixel from the planes of its
// triangle, rounded to p bits, then lit. Each visible pixel is lit once, and what is hidden never.
//
// One pixel after the other goes through one set of planes and one lighting core.
//
// Interval: a cycle a lane and light; the RTL takes none for a lane of background beside covered ones.
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
  if (!is_set(in.empty)) database.planes[int(raw(in.index)) - 1] = in;
  return is_set(in.last);
}

// The component of a normal at pixel (x, y), without the offset that it has in a plane: in bits, its top bit inverted.
template <class F>
typename F::Normal normal_component(const typename F::NormalPlane& start, const typename F::NormalGradient& dx,
                                    const typename F::NormalGradient& dy, int x, int y) {
  using Value = typename F::NormalChannel::Value;
  const Value offset = plane_at<F>(start, dx, dy, x, y);  // rounded: the start has the ½
  return slice<typename F::Normal>(Value(offset + from_raw<Value>(std::uint64_t(1) << F::Normal::fraction())), 0);
}

// A normal, and what its lights take of its length.
template <class F>
struct PixelNormal {
  typename F::Normal n[3];
  ReciprocalRoot<F> inverse;
};
template <class F>
PixelNormal<F> pixel_normal(const NormalPlanes<F>& planes, int x, int y) {
  PixelNormal<F> normal;
Components:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    normal.n[i] = normal_component<F>(planes.start[i], planes.dx[i], planes.dy[i], x, y);
  }
  normal.inverse = reciprocal_length<F>(normal.n);
  return normal;
}

// A pixel that has one light: a function of the word of TdbS, the registers and the place.
template <class F>
Rgb<F> phong_pixel(const NormalPlanes<F>& planes, const Light<F>& light, const Material<F>& entry, int x, int y) {
  const PixelNormal<F> normal = pixel_normal<F>(planes, x, y);
  return rounded_colours(add_light(LitSum<F>{}, normal.n, normal.inverse, light, entry));
}

// A turn takes a light of a lane; the first of a stamp reads it, and the last writes its pixels.
template <Until kUntil, class F>
bool shade_phong_stamps(const Frame<F>& frame, Stream<Scan<F>>& scan, const NormalDatabase<F>& database,
                        const LightTable<F>& lights, const MaterialTable<F>& materials, Stream<Pixel<F>>& pixel) {
  Scan<F> in{};
  Pixel<F> out{};
  PixelNormal<F> normal{};
  LitSum<F> sum{};
  int lane = 0, light = 0;
  bool last = false, done = false;
Turns:
  while (!done) {
    HS_PIPELINE(1)
    if (lane == 0 && light == 0) in = scan.read();
    const bool is_last_light = light == F::kLights - 1;
    Rgb<F> colour = {{frame.r, frame.g, frame.b}};
    if (is_set(in.index[lane])) {
      const NormalPlanes<F>& planes = database.planes[int(raw(in.index[lane])) - 1];
      if (light == 0) {
        const int x = int(raw(in.x)) << F::kLog2LanesX, y = int(raw(in.y)) << F::kLog2LanesY;
        normal = pixel_normal<F>(planes, x + (lane & (F::kLanesX - 1)), y + (lane >> F::kLog2LanesX));
        sum = LitSum<F>{};
      }
      sum = add_light(sum, normal.n, normal.inverse, lights.light[light],
                      materials.entry[int(raw(planes.material))][light]);
      if (is_last_light) colour = rounded_colours(sum);
    }
    out.r[lane] = colour.channel[0];
    out.g[lane] = colour.channel[1];
    out.b[lane] = colour.channel[2];
    light = is_last_light ? 0 : light + 1;
    lane = is_last_light ? (lane + 1) & (F::kLanes - 1) : lane;
    if (lane == 0 && light == 0) {
      out.last = in.last;
      out.x = in.x;
      out.y = in.y;
      pixel.write(out);
      last = is_set(in.last);
      done = kUntil == Until::kStampEnds || last;
    }
  }
  return last;
}

template <class F>
bool shade_phong(const Frame<F>& frame, Stream<Scan<F>>& scan, const NormalDatabase<F>& database,
                 const LightTable<F>& lights, const MaterialTable<F>& materials, Stream<Pixel<F>>& pixel) {
  return shade_phong_stamps<Until::kStampEnds>(frame, scan, database, lights, materials, pixel);
}
template <class F>
void shade_phong_frame(const Frame<F>& frame, Stream<Scan<F>>& scan, const NormalDatabase<F>& database,
                       const LightTable<F>& lights, const MaterialTable<F>& materials, Stream<Pixel<F>>& pixel) {
  shade_phong_stamps<Until::kFrameEnds>(frame, scan, database, lights, materials, pixel);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_SHADE_SHADE_PHONG_HPP_
