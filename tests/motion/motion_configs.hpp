// SPDX-License-Identifier: Apache-2.0
// Configurations with motion, as in configs/*.toml, compiled.
#ifndef HALFSPACE_TESTS_MOTION_CONFIGS_HPP_
#define HALFSPACE_TESTS_MOTION_CONFIGS_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct MotionLow {
  static constexpr Config config() {
    return {"motion_low",
            320,
            240,
            8192,
            10,
            4,
            16,
            8,
            18,
            13,
            0,
            4,
            Shading::kMotion,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kNone,
            TextureMapping::kAffine,
            0,
            0,
            14,
            12,
            KeyFilter::kNearest,
            6,
            4,
            4,
            8,
            0,
            1};
  }
};
struct MotionMiddle {
  static constexpr Config config() {
    return {"motion_middle",
            640,
            480,
            16384,
            11,
            8,
            24,
            8,
            26,
            14,
            15,
            4,
            Shading::kMotion,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kNone,
            TextureMapping::kPerspective,
            0,
            0,
            20,
            13,
            KeyFilter::kBilinear,
            8,
            5,
            6,
            14,
            1,
            1};
  }
};
struct MotionHigh {
  static constexpr Config config() {
    return {"motion_high",
            1920,
            1080,
            262144,
            14,
            8,
            24,
            8,
            28,
            15,
            18,
            4,
            Shading::kMotion,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kNone,
            TextureMapping::kPerspective,
            0,
            0,
            24,
            15,
            KeyFilter::kBicubic,
            10,
            6,
            8,
            18,
            1,
            4};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_MOTION_CONFIGS_HPP_
