// SPDX-License-Identifier: Apache-2.0
// The buffers of the kernels, read back as a frame.
#ifndef HALFSPACE_MODEL_PIPELINE_KERNELS_BUFFERS_HPP_
#define HALFSPACE_MODEL_PIPELINE_KERNELS_BUFFERS_HPP_

#include "hls/pipeline/pipeline.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::model {

// The depth of a pixel, in lane `lane` of a stamp, that triangle `index` > 0 has drawn: of the Z-buffer, or of TdbV.
template <class F>
std::uint32_t stored_depth(const Buffers<F>& buffers, int x, int y, int lane, std::uint32_t index) {
  typename F::Depth depth[F::kLanes] = {};
  choose(
      typename F::CompilesPlaneTest(), F::kTestsPlanes, depth, buffers,
      [&](auto& depth, auto& b) {
        Bit lanes[F::kLanes] = {};
        lanes[lane] = from_raw<Bit>(1);
        const DepthEntry<F> plane = b.visibility.entry[int(index) - 1];
        plane_lanes<F>(plane.origin, plane.dx, plane.dy, x << F::kLog2LanesX, y << F::kLog2LanesY, lanes, depth);
      },
      [&](auto& depth, auto& b) { depth[lane] = b.depth.depth[y * F::kStampsX + x][lane]; });
  return std::uint32_t(raw(depth[lane]));
}

// The I-buffer, before the scan-out clears it, and the depths.
template <class F>
void copy_buffers(const Buffers<F>& buffers, const ref::SnappedList& scene, ref::Frame& frame) {
  frame.width = scene.width;
  frame.height = scene.height;
  frame.index.resize(std::size_t(scene.width) * scene.height);
  frame.depth.resize(frame.index.size());
  const std::uint32_t farthest = ref::full_depth(F::kDepthBits);
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const int stamp_x = x >> F::kLog2LanesX, stamp_y = y >> F::kLog2LanesY;
      const int lane = y % F::kLanesY * F::kLanesX + x % F::kLanesX;
      const std::uint32_t index = raw(buffers.index.index[stamp_y * F::kStampsX + stamp_x][lane]);
      const bool is_drawn = index != 0 && F::kHasDepth;
      const std::size_t at = std::size_t(y) * scene.width + x;
      frame.index[at] = index;
      frame.depth[at] = is_drawn ? stored_depth<F>(buffers, stamp_x, stamp_y, lane, index) : farthest;
    }
  }
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_KERNELS_BUFFERS_HPP_
