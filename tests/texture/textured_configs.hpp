// SPDX-License-Identifier: Apache-2.0
// Configurations with texture, as in configs/*.toml, compiled.
#ifndef HALFSPACE_TESTS_TEXTURED_CONFIGS_HPP_
#define HALFSPACE_TESTS_TEXTURED_CONFIGS_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct TexturedLow {
  static constexpr Config config() {
    return {"textured_low",
            320,
            200,
            4096,
            10,
            4,
            16,
            8,
            18,
            13,
            14,
            4,
            Shading::kGouraud,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kNearest,
            TextureMapping::kAffine,
            4096,
            16,
            16,
            13};
  }
};
struct TexturedMiddle {
  static constexpr Config config() {
    return {"textured_middle",
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
            Shading::kGouraud,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kBilinear,
            TextureMapping::kPerspective,
            65536,
            32,
            24,
            14};
  }
};
struct TexturedHigh {
  static constexpr Config config() {
    return {"textured_high",
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
            Shading::kGouraud,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kBilinear,
            TextureMapping::kPerspective,
            1048576,
            64,
            24,
            15};
  }
};
struct TexturedFlat {
  static constexpr Config config() {
    return {"textured_flat",
            160,
            120,
            4000,
            9,
            6,
            0,
            6,
            22,
            0,
            0,
            4,
            Shading::kFlat,
            Architecture::kDelta,
            0,
            0,
            0,
            0,
            0,
            TextureFilter::kNearest,
            TextureMapping::kPerspective,
            16384,
            5,
            20,
            11};
  }
};
struct TexturedPhong {
  static constexpr Config config() {
    return {"textured_phong",
            320,
            200,
            4096,
            10,
            4,
            16,
            8,
            18,
            13,
            0,
            4,
            Shading::kPhong,
            Architecture::kDelta,
            9,
            1,
            16,
            16,
            13,
            TextureFilter::kBilinear,
            TextureMapping::kAffine,
            16384,
            8,
            16,
            13};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_TEXTURED_CONFIGS_HPP_
