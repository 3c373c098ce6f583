// SPDX-License-Identifier: Apache-2.0
// Configuration `low` for the kernels, in the order of Config.
// Printed by `halfspace config low --header FILE` from its .toml file: change that, not this one.
#ifndef HALFSPACE_CONFIGS_LOW_HPP_
#define HALFSPACE_CONFIGS_LOW_HPP_

#include "hls/formats/config.hpp"

namespace halfspace {

struct Low {
  static constexpr Config config() {
    return {"low", 320, 200, 4096, 10, 4, 16, 8, 18, 13, 14, 4, Shading::kGouraud, Architecture::kDelta};
  }
};

}  // namespace halfspace

#endif  // HALFSPACE_CONFIGS_LOW_HPP_
