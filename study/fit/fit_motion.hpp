// SPDX-License-Identifier: Apache-2.0
// The cheapest configuration of motion that makes the frames between key frames as the reference makes them, with
// nothing rounded: fine vectors and weights, in perspective, light added, by the filter that is named. The search is
// that of fit.hpp; the goal's dB, LSB and wrong pixels are those of MotionTrade against that reference.
#ifndef HALFSPACE_STUDY_FIT_FIT_MOTION_HPP_
#define HALFSPACE_STUDY_FIT_FIT_MOTION_HPP_

#include <functional>
#include <string>
#include <vector>

#include "study/fit/fit.hpp"
#include "study/trade/motion_trade.hpp"

namespace halfspace::model {

struct MotionFit {
  Configuration configuration;
  MotionTrade outcome;
  std::vector<FitLess> less;
  std::uint64_t tried = 0;
  std::size_t ends = 1;
  double cost = 0;
};

// Throws ref::Error when no configuration reaches the goal.
MotionFit fit_motion(const MotionInput&, const std::string& name, const FitGoal&, KeyFilter filter,
                     const std::function<void(std::uint64_t)>& progress);

// The fields of the frames in between, as the pipeline draws them.
std::vector<NamedFrame> motion_frames(const MotionInput&, const Configuration&);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_FIT_FIT_MOTION_HPP_
