// SPDX-License-Identifier: Apache-2.0
// The plots of a sweep, by gnuplot.
#ifndef HALFSPACE_CLI_SWEEP_SWEEP_PLOTS_HPP_
#define HALFSPACE_CLI_SWEEP_SWEEP_PLOTS_HPP_

#include <optional>
#include <string>
#include <vector>

#include "cli/sweep/sweep_script.hpp"

namespace halfspace::cli {

// What a number that was varied buys: KEY.png, a panel a measure, a curve a scene, all else as in the base. None for a
// number that has no panels, or one value.
std::optional<PanelScript> curves_plot(const Sweep& sweep, const std::vector<Json>& rows, const Variation& variation);

// front.png: accuracy against LUTs, or else memory and multipliers, and against cycles; the Pareto fronts. None of one
// configuration alone.
std::optional<PanelScript> front_plot(const Sweep& sweep, const std::vector<Json>& rows);

// map.png, where reciprocal bits and fraction bits were varied together.
std::optional<PanelScript> map_plot(const Sweep& sweep, const std::vector<Json>& rows);

// Writes all of them. Returns their paths. Throws ref::Error when gnuplot is not there, or fails.
std::vector<std::string> draw_plots(const Sweep& sweep, const std::vector<Json>& rows);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SWEEP_SWEEP_PLOTS_HPP_
