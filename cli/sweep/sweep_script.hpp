// SPDX-License-Identifier: Apache-2.0
// What the plots of a sweep have in common: several of them as panels of one picture.
#ifndef HALFSPACE_CLI_SWEEP_SWEEP_SCRIPT_HPP_
#define HALFSPACE_CLI_SWEEP_SWEEP_SCRIPT_HPP_

#include <optional>
#include <string>

#include "cli/sweep/sweep_points.hpp"

namespace halfspace::cli {

// A script for gnuplot.
class PanelScript {
 public:
  // Of the picture `name`, panels of the size in pixels, by columns and lines.
  PanelScript(std::string name, const std::string& title, int columns, int lines, int panel_width, int panel_height);
  void line(const std::string& text) { text_ += text + '\n'; }
  // Returns the name of the block of data.
  std::string data(const std::string& lines);

  const std::string& name() const { return name_; }
  std::string text() const;

 private:
  std::string name_, text_;
  int width_, height_, blocks_ = 0;
};

// A column of a row of the table; none where it was not measured.
std::optional<double> number(const Json& row, const std::string& column);

// One a curve, again from the first on when there are no more.
const char* curve_colour(std::size_t n);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SWEEP_SWEEP_SCRIPT_HPP_
