// SPDX-License-Identifier: Apache-2.0
// Configurations with lighting, as in configs/*.toml, compiled.
#ifndef HALFSPACE_TESTS_LIT_CONFIGS_HPP_
#define HALFSPACE_TESTS_LIT_CONFIGS_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct LitLow {
  static constexpr Config config() {
    return {"lit_low", 320, 200, 4096, 10, 4, 16, 8, 18, 13, 14, 4, Shading::kGouraud, Architecture::kDelta,
            9,         1,   16,  16};
  }
};
struct LitMiddle {
  static constexpr Config config() {
    return {"lit_middle",         640, 480, 16384, 11, 8, 24, 8, 26, 14, 15, 4, Shading::kGouraud,
            Architecture::kDelta, 11,  2,   8,     32};
  }
};
struct LitHigh {
  static constexpr Config config() {
    return {"lit_high",           1920, 1080, 262144, 14, 8, 24, 8, 28, 15, 18, 4, Shading::kGouraud,
            Architecture::kDelta, 13,   4,    16,     512};
  }
};
struct PhongLow {
  static constexpr Config config() {
    return {"phong_low",          320, 200, 4096, 10, 4, 16, 8, 18, 13, 0, 4, Shading::kPhong,
            Architecture::kDelta, 9,   1,   16,   16, 13};
  }
};
struct PhongMiddle {
  static constexpr Config config() {
    return {"phong_middle",       640, 480, 16384, 11,  8, 24, 8, 26, 14, 0, 4, Shading::kPhong,
            Architecture::kDelta, 11,  2,   16,    512, 15};
  }
};
struct PhongHigh {
  static constexpr Config config() {
    return {"phong_high",         1920, 1080, 262144, 14,  8, 24, 8, 28, 15, 0, 4, Shading::kPhong,
            Architecture::kDelta, 13,   4,    16,     512, 18};
  }
};
struct LitMatte {
  static constexpr Config config() {
    return {"lit_matte", 160, 120, 500, 9, 6, 0, 8, 0, 0, 0, 4, Shading::kFlat, Architecture::kDelta, 10, 3, 0, 20};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_LIT_CONFIGS_HPP_
