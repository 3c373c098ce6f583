// SPDX-License-Identifier: Apache-2.0
// A small configuration that nobody named, with and without its features.
#ifndef HALFSPACE_TESTS_FEATURE_CONFIGS_HPP_
#define HALFSPACE_TESTS_FEATURE_CONFIGS_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct GouraudDepth {
  static constexpr Config config() {
    return {"gouraud_depth", 160, 120, 500, 9, 6, 18, 8, 20, 12, 14, 4, Shading::kGouraud};
  }
};
struct GouraudOnly {
  static constexpr Config config() {
    return {"gouraud_only", 160, 120, 500, 9, 6, 0, 8, 20, 0, 14, 4, Shading::kGouraud};
  }
};
struct FlatDepth {
  static constexpr Config config() { return {"flat_depth", 160, 120, 500, 9, 6, 18, 8, 20, 12, 0, 4, Shading::kFlat}; }
};
struct FlatOnly {
  static constexpr Config config() { return {"flat_only", 160, 120, 500, 9, 6, 0, 8, 0, 0, 0, 4, Shading::kFlat}; }
};

struct Gamma {
  static constexpr Config config() {
    return {"gamma", 160, 120, 4000, 9, 6, 18, 8, 20, 12, 14, 4, Shading::kGouraud, Architecture::kGamma};
  }
};
struct GammaFlat {
  static constexpr Config config() {
    return {"gamma_flat", 160, 120, 500, 9, 6, 18, 8, 20, 12, 0, 4, Shading::kFlat, Architecture::kGamma};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_FEATURE_CONFIGS_HPP_
