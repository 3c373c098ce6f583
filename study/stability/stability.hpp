// SPDX-License-Identifier: Apache-2.0
// How far off the planes of depth and colour are before rounding, against the shape and the size of triangles: the
// kernels of a configuration beside other ways to do it (study/stability/plane_models.hpp).
#ifndef HALFSPACE_STUDY_STABILITY_STABILITY_HPP_
#define HALFSPACE_STUDY_STABILITY_STABILITY_HPP_

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hls/formats/config.hpp"

namespace halfspace::model {

enum PlaneMethod { kKernelPlane, kFloatFromOrigin, kFloatFromVertex, kSaturatedGradients, kPlaneMethods };
const char* plane_method_name(PlaneMethod method);

struct PlaneErrors {
  std::array<double, kPlaneMethods> largest{};        // LSB, at a covered pixel centre
  std::array<std::uint64_t, kPlaneMethods> beyond{};  // pixels that are off by more than ½ LSB
};

struct StabilityPoint {
  int log2 = 0;  // of the aspect ratio, or of the size in pixels
  std::uint64_t triangles = 0, pixels = 0;
  double longest = 0;  // edge, pixels
  PlaneErrors depth, colour;
};

struct StabilityStudy {
  // By length²/D, length over width, from 2^0 up: triangles as long as the frame is wide.
  std::vector<StabilityPoint> aspect;
  // By the side of the box, up to the guard band: aspect ratios up to 8.
  std::vector<StabilityPoint> size;
  int reachable = 0;  // log2 of the largest aspect ratio that the grid of the configuration has with a covered pixel
  double depth_bound = 0, colour_bound = 0;  // proved for the kernels, LSB; 0: the configuration has no such plane
};

struct StabilityOptions {
  int triangles = 400;      // a point
  int largest_aspect = 30;  // log2
  std::uint64_t seed = 1;
  std::function<void(std::size_t done, std::size_t total)> progress;  // may be empty
};

StabilityStudy stability_study(const Config& config, const StabilityOptions& options);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_STABILITY_STABILITY_HPP_
