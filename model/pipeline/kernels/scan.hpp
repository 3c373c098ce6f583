// SPDX-License-Identifier: Apache-2.0
// A finished frame out of the kernels, as a picture.
#ifndef HALFSPACE_MODEL_PIPELINE_KERNELS_SCAN_HPP_
#define HALFSPACE_MODEL_PIPELINE_KERNELS_SCAN_HPP_

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "hls/pipeline/pipeline.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::model {

using Colours8 = std::vector<std::array<std::uint8_t, 4>>;  // RGBA, row by row

template <class F>
std::uint32_t displayed(const typename F::Colour& colour) {
  return ref::displayed_colour(std::uint32_t(raw(colour)), F::kColourBits);
}

// The pixels of a stamp that are inside the frame.
template <class F>
void put_stamp(const Pixel<F>& in, int width, int height, Colours8& colour) {
  std::uint32_t rgba[F::kLanes];  // little endian: r first in memory
  for (int l = 0; l < F::kLanes; ++l) {
    rgba[l] = displayed<F>(in.r[l]) | displayed<F>(in.g[l]) << 8 | displayed<F>(in.b[l]) << 16 | 255u << 24;
  }
  const int x = int(raw(in.x)) * F::kLanesX, y = int(raw(in.y)) * F::kLanesY;
  const int columns = width - x, rows = std::min(F::kLanesY, height - y);
  for (int j = 0; j < rows; ++j) {
    auto* row = &colour[std::size_t(y + j) * width + x];
    if (columns >= F::kLanesX) std::memcpy(row, rgba + j * F::kLanesX, sizeof(*rgba) * F::kLanesX);
    else std::memcpy(row, rgba + j * F::kLanesX, sizeof(*rgba) * columns);
  }
}

// Scans the frame out and clears the I-buffer. What a motion configuration gives goes to a tap or nowhere.
template <class F>
void scan_out(const ref::SnappedList& scene, const Frame<F>& registers, Streams<F>& streams, Buffers<F>& buffers,
              Colours8& colour) {
  colour.resize(!F::kShades ? 0 : std::size_t(scene.width) * scene.height);
  for (int stamp_y = 0; stamp_y * F::kLanesY < scene.height; ++stamp_y) {
    pipeline_scan(registers, stamp_y, streams, buffers);
    while (!F::kShades && !streams.scan.empty()) {
      pipeline_motion(streams, buffers);
      while (!streams.motion.empty()) streams.motion.read();
    }
    while (!streams.scan.empty()) {
      if (F::kUpConverts) pipeline_mask(Pass::kKey, streams, buffers);
      pipeline_shade(registers, streams, buffers);
      if (F::kUpConverts) streams.stored_scan.read();
      put_stamp<F>(F::kHasObjects ? Pixel<F>(streams.entry.read()) : streams.pixel.read(), scene.width, scene.height,
                   colour);
    }
  }
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_KERNELS_SCAN_HPP_
