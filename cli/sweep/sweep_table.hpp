// SPDX-License-Identifier: Apache-2.0
// The results of a sweep side by side.
#ifndef HALFSPACE_CLI_SWEEP_SWEEP_TABLE_HPP_
#define HALFSPACE_CLI_SWEEP_SWEEP_TABLE_HPP_

#include "cli/sweep/sweep_points.hpp"

namespace halfspace::cli {

// A row a configuration on a scene, refused ones included, all with the same fields; what was not measured is null.
//   scene, width, height, config, named, base, the numbers of the configuration, refused (why), the measures of the
//   picture, lut_<target> and the other columns of the area, and the Pareto fronts (see mark_fronts).
// Throws ref::Error when points are missing.
std::vector<Json> sweep_rows(const Sweep& sweep);

// sweep.csv and sweep.json.
void write_table(const Sweep& sweep, const std::vector<Json>& rows);

// Of the first target, if area was measured.
std::string lut_column(const Sweep& sweep);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SWEEP_SWEEP_TABLE_HPP_
