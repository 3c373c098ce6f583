// SPDX-License-Identifier: Apache-2.0
// Configurations tried against the ideal pictures of a scene, and the search of one that nothing can be taken from.
#ifndef HALFSPACE_STUDY_FIT_FIT_SEARCH_HPP_
#define HALFSPACE_STUDY_FIT_FIT_SEARCH_HPP_

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/pipeline/engine.hpp"
#include "study/fit/fit.hpp"
#include "study/fit/fit_costs.hpp"
#include "study/fit/fit_steps.hpp"

namespace halfspace::model {

class FitSearch {
 public:
  FitSearch(const FitScene& scene, const FitGoal& goal, const std::function<void(std::uint64_t)>& progress);

  // Every frame with these numbers, up to the first that misses the goal.
  const FitOutcome& try_config(Config);
  bool holds(const Config& c) { return try_config(c).holds; }
  FitOutcome draw(const Config&, Engine&) const;
  std::uint64_t tried() const { return outcomes_.size(); }

 private:
  // The runtime engine holds a TdbS of all triangles that a configuration allows: no more than the scene can have.
  Config small(Config);
  void judge(const ref::Frame& frame, const ref::TriangleList& list, std::size_t k, int depth_bits,
             FitOutcome& outcome) const;

  const FitScene& scene_;
  const FitGoal& goal_;
  const std::function<void(std::uint64_t)>& progress_;
  std::vector<ref::IdealFrame> ideals_;
  std::map<std::vector<int>, FitOutcome> outcomes_;
  std::size_t most_triangles_ = 0;
  mutable std::size_t failed_ = 0;  // the frame that missed the goal last: it is looked at first
};

// How a search tells configurations apart.
struct FitTrials {
  std::function<bool(const Config&)> holds;
  std::function<std::array<double, 3>(const Config&)> cost;
};
// `c` holds. Every end that was found: nothing can be taken from any, the cheapest first.
std::vector<Config> fit_ends(const FitTrials&, const Config& c);
// A step less of a number, or where there is none the number that is refused.
Config fit_less(const Config&, const ConfigField&);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_FIT_FIT_SEARCH_HPP_
