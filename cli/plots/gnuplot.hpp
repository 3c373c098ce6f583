// SPDX-License-Identifier: Apache-2.0
// Pictures of numbers, drawn by the program gnuplot.
#ifndef HALFSPACE_CLI_PLOTS_GNUPLOT_HPP_
#define HALFSPACE_CLI_PLOTS_GNUPLOT_HPP_

#include <string>

namespace halfspace::cli {

bool gnuplot_is_installed();
// A string of a gnuplot script.
std::string gnuplot_quoted(const std::string& text);
// The PNG that a script draws, which sets its terminal and no output. Throws ref::Error, about the file of that name,
// when there is none.
std::string drawn_by_gnuplot(const std::string& script, const std::string& name);
// The same, written to the file.
void run_gnuplot(const std::string& script, const std::string& picture);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PLOTS_GNUPLOT_HPP_
