// SPDX-License-Identifier: Apache-2.0
// Configuration `middle` for the kernels, in the order of Config.
// Printed by `halfspace config middle --header FILE` from its .toml file: change that, not this one.
#ifndef HALFSPACE_CONFIGS_MIDDLE_HPP_
#define HALFSPACE_CONFIGS_MIDDLE_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct Middle {
  static constexpr Config config() {
    return {"middle", 640, 480, 16384, 11, 8, 24, 8, 26, 14, 15, 4, Shading::kGouraud, Architecture::kDelta};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_CONFIGS_MIDDLE_HPP_
