// SPDX-License-Identifier: Apache-2.0
// Runs one triangle through triangle_setup and raster_pineda and gives its coverage as a bitmap.
#ifndef HALFSPACE_TESTS_RASTER_KERNEL_COVERAGE_HPP_
#define HALFSPACE_TESTS_RASTER_KERNEL_COVERAGE_HPP_

#include <string>
#include <vector>

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "hls/raster/raster_pineda.hpp"
#include "hls/setup/triangle_setup.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::tests {

template <class F>
class CoverageKernel {
 public:
  CoverageKernel(int width, int height) : width_(width), height_(height), covered_(width * height) {
    frame_.width = from_raw<typename F::X>(width);
    frame_.height = from_raw<typename F::Y>(height);
  }

  // The stamps of the triangle. Each pixel of the bitmap counts how often it was covered.
  const std::vector<int>& draw(const ref::SnappedTriangle& in) {
    Triangle<F> t{};
    for (int v = 0; v < 3; ++v) {
      t.x[v] = from_raw<typename F::Coord>(in.x[v]);
      t.y[v] = from_raw<typename F::Coord>(in.y[v]);
      t.depth[v] = from_raw<typename F::Depth>(in.depth[v]);
    }
    triangle_.write(t);
    triangle_setup(frame_, triangle_, setup_, attributes_);
    if (!attributes_.empty()) attributes_.read();
    raster_pineda(frame_, setup_, stamp_, triangle_depth_, visits_);
    if (F::kTestsPlanes) triangle_depth_.read();
    std::fill(covered_.begin(), covered_.end(), 0);
    stamps = covered_stamps = last_flags = outside = 0;
    while (!stamp_.empty()) {
      const Stamp<F> s = stamp_.read();
      ++stamps;
      last_flags += raw(s.triangle_last);
      bool any = false;
      for (int l = 0; l < F::kLanes; ++l) {
        if (!raw(s.mask[l])) continue;
        any = true;
        const int x = int(raw(s.x)) * F::kLanesX + l % F::kLanesX, y = int(raw(s.y)) * F::kLanesY + l / F::kLanesX;
        if (x >= width_ || y >= height_) ++outside;
        else ++covered_[y * width_ + x];
      }
      covered_stamps += any;
    }
    return covered_;
  }

  // How many pixels the kernel covers otherwise than exact arithmetic, stray fragments and lost ends included.
  int mismatches(const ref::SnappedTriangle& t) {
    draw(t);
    int wrong = outside + (last_flags != 1) + (stamps - covered_stamps > (covered_stamps == 0));
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        wrong += covered_[y * width_ + x] != int(ref::covers(t, F::kSubpixelBits, x, y));
      }
    }
    return wrong;
  }

  int stamps = 0, covered_stamps = 0, last_flags = 0, outside = 0;  // of the last triangle drawn

 private:
  int width_, height_;
  Frame<F> frame_{};
  Stream<Triangle<F>> triangle_;
  Stream<Setup<F>> setup_;
  Stream<Attributes<F>> attributes_;
  Stream<Stamp<F>> stamp_;
  Stream<TriangleDepth<F>> triangle_depth_;
  Probe<int> visits_;
  std::vector<int> covered_;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_RASTER_KERNEL_COVERAGE_HPP_
