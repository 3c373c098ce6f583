// SPDX-License-Identifier: Apache-2.0
// Pictures of numbers, drawn by the program gnuplot.
#ifndef HALFSPACE_CLI_PLOTS_GNUPLOT_HPP_
#define HALFSPACE_CLI_PLOTS_GNUPLOT_HPP_

#include <string>

namespace halfspace::cli {

bool gnuplot_is_installed();
// A string of a gnuplot script.
std::string gnuplot_quoted(const std::string& text);
// Runs a script that writes `picture`. Throws ref::Error when it did not.
void run_gnuplot(const std::string& script, const std::string& picture);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PLOTS_GNUPLOT_HPP_
