// SPDX-License-Identifier: Apache-2.0
// What a configuration costs, as the search of one compares it.
#ifndef HALFSPACE_STUDY_FIT_FIT_COSTS_HPP_
#define HALFSPACE_STUDY_FIT_FIT_COSTS_HPP_

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "study/fit/fit.hpp"

namespace halfspace::model {

// All fields but the name.
std::vector<int> fit_key(const Config&);

// Memories of a frame, those of texture as well.
std::uint64_t all_memory_bits(const Config&);
// Of all kinds of numbers that the units have: what registers, adders and multiplexers are as wide as.
std::uint64_t logic_bits(const Config&);

// Cycles and bytes of the frame that takes most, by the models.
struct FitTraffic {
  std::uint64_t cycles = 0, bytes = 0;
};
FitTraffic slowest_frame(const FitScene&, const Config&);

class FitCosts {
 public:
  // `triangles`: of the frame that has most.
  FitCosts(const FitScene& scene, FitCost cost, int triangles) : scene_(scene), cost_(cost), triangles_(triangles) {}

  // The cost that was asked for; what is as cheap by it is compared by the bits of its numbers, and of its memories.
  std::array<double, 3> of(Config);

 private:
  const FitScene& scene_;
  const FitCost cost_;
  const int triangles_;
  std::map<std::vector<int>, FitTraffic> traffic_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_FIT_FIT_COSTS_HPP_
