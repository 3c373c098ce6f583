// SPDX-License-Identifier: Apache-2.0
// The bars of the papers' figures, from the numbers of `halfspace repro`.
#ifndef HALFSPACE_CLI_REPRO_REPRO_PLOTS_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_PLOTS_HPP_

#include <string>
#include <vector>

#include "cli/commands.hpp"

namespace halfspace::cli {

// Write pictures into the folder and return their names. Throw ref::Error when gnuplot fails.
std::vector<std::string> plot_index_rendering(const Json& numbers, const std::string& folder);
std::vector<std::string> plot_lighting_cost(const Json& numbers, const std::string& folder);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_PLOTS_HPP_
