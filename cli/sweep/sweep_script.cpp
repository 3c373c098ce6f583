// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_script.hpp"

#include <fmt/format.h>

#include "cli/plots/gnuplot.hpp"

namespace halfspace::cli {
namespace {

constexpr int kTitleHeight = 30;

}  // namespace

PanelScript::PanelScript(std::string name, const std::string& title, int columns, int lines, int panel_width,
                         int panel_height)
    : name_(std::move(name)), width_(panel_width * columns), height_(panel_height * lines + kTitleHeight) {
  text_ = fmt::format(
      "set multiplot layout {},{} title {} font ',13'\nset grid lt 1 lw 0.5 lc rgb '#cccccc'\nset border 3\n"
      "set tics nomirror\n",
      lines, columns, gnuplot_quoted(title));
}

std::string PanelScript::data(const std::string& lines) {
  const std::string name = fmt::format("$data{}", blocks_++);
  text_ += name + " << EOD\n" + lines + "EOD\n";
  return name;
}

std::string PanelScript::text() const {
  return fmt::format(
      "set terminal pngcairo size {},{} font 'sans,11' linewidth 1.5 noenhanced background rgb 'white'\n"
      "{}unset multiplot\n",
      width_, height_, text_);
}

std::optional<double> number(const Json& row, const std::string& column) {
  if (!row["refused"].is_null() || !row.contains(column) || !row[column].is_number()) return std::nullopt;
  return row[column].get<double>();
}

const char* curve_colour(std::size_t n) {
  constexpr const char* kColours[] = {"#1f6fb4", "#d95f02", "#2a9d5c", "#8a4fa8", "#8c6d31", "#c0397b"};
  return kColours[n % (sizeof kColours / sizeof *kColours)];
}

}  // namespace halfspace::cli
