// SPDX-License-Identifier: Apache-2.0
// The points of a sweep, computed.
#ifndef HALFSPACE_CLI_SWEEP_SWEEP_MEASURE_HPP_
#define HALFSPACE_CLI_SWEEP_SWEEP_MEASURE_HPP_

#include "cli/sweep/sweep_points.hpp"

namespace halfspace::cli {

// Computes the point and writes its file, whole. A scene that does not fit the configuration is a result as well.
// Throws ref::Error when the tool for the area fails.
void compute_point(const Sweep& sweep, const SweepPoint& point);

// Every point that has no file yet, `jobs` at a time, with progress on standard error. Returns what failed, a sentence
// each.
std::vector<std::string> compute_points(const Sweep& sweep, int jobs);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SWEEP_SWEEP_MEASURE_HPP_
