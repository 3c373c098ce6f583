// SPDX-License-Identifier: Apache-2.0
// halfspace fit with --keys: a configuration of motion.
#ifndef HALFSPACE_CLI_COMMON_FIT_BETWEEN_HPP_
#define HALFSPACE_CLI_COMMON_FIT_BETWEEN_HPP_

#include <string>

#include "cli/common/scene_frames.hpp"
#include "study/fit/fit.hpp"

namespace halfspace::cli {

struct BetweenOptions {
  FrameInput input;
  model::FitGoal goal;
  int keys = 0;  // frames made for each key frame
  std::string filter = "bilinear", cost, output, work, json;
  bool cosim = true;
};
// Throws ref::Error.
void fit_between(const BetweenOptions& options);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_FIT_BETWEEN_HPP_
