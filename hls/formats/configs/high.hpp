// SPDX-License-Identifier: Apache-2.0
// Configuration `high` for the kernels, in the order of Config.
// Printed by `halfspace config high --header FILE` from its .toml file: change that, not this one.
#ifndef HALFSPACE_CONFIGS_HIGH_HPP_
#define HALFSPACE_CONFIGS_HIGH_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct High {
  static constexpr Config config() {
    return {"high", 1920, 1080, 262144, 14, 8, 24, 8, 28, 15, 18, 4, Shading::kGouraud, Architecture::kDelta};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_CONFIGS_HIGH_HPP_
