// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cli/plots/gnuplot.hpp"
#include "cli/sweep/sweep_plots.hpp"

namespace halfspace::cli {

std::optional<PanelScript> map_plot(const Sweep& sweep, const std::vector<Json>& rows) {
  std::string fraction;
  bool reciprocal = false;
  for (const Variation& variation : sweep.variations) {
    reciprocal = reciprocal || (variation.key == "reciprocal_bits" && variation.values.size() > 1);
    if (variation.key.find("_fraction") != std::string::npos && variation.values.size() > 1) fraction = variation.key;
  }
  if (sweep.input.choice.star || !reciprocal || fraction.empty()) return std::nullopt;
  const bool depth = fraction == "depth_fraction";
  const std::string column = depth ? "depth_misrounded_share" : "colour_misrounded_share";
  const int count = int(sweep.scenes.size()), columns = std::min(count, 3);
  PanelScript script("map.png",
                     depth ? "percent of depths that are not rounded to nearest"
                           : "percent of colours that are not rounded to nearest",
                     columns, (count + columns - 1) / columns, 520, 430);
  script.line(fmt::format(
      "set xlabel 'reciprocal bits r'\nset ylabel {}\nset xtics 1\nset ytics 1\nunset key\nunset grid\n"
      "set palette defined (0 '#f7fbff', 1 '#5a9fd0')\nset cbrange [0:*]\nunset colorbox\n"
      "set offsets 0.5, 0.5, 0.5, 0.5\nset autoscale fix",
      gnuplot_quoted(depth ? "fraction bits of depth gradients g" : "fraction bits of colour gradients g")));
  for (const SweepScene& scene : sweep.scenes) {
    std::string cells, refused;
    for (const Json& row : rows) {
      if (row["scene"] != scene.name || (row["named"].is_string() && !row["base"].get<bool>())) continue;
      if (const auto value = number(row, column)) {
        cells += fmt::format("{} {} {}\n", row["reciprocal_bits"].get<int>(), row[fraction].get<int>(), 100 * *value);
      } else {
        refused += fmt::format("{} {}\n", row["reciprocal_bits"].get<int>(), row[fraction].get<int>());
      }
    }
    if (cells.empty()) continue;
    script.line(fmt::format("set title {}", gnuplot_quoted(short_name(scene.name) + " (×: refused)")));
    const std::string block = script.data(cells);
    std::string plot = fmt::format(
        "plot {0} using 1:2:(0.5):(0.5):3 with boxxyerror fs solid noborder fc palette, {0} using 1:2:(sprintf('%.2f', "
        "$3)) with labels font ',9'",
        block);
    if (!refused.empty()) plot += fmt::format(", {} with points pt 2 lc rgb '#999999'", script.data(refused));
    script.line(plot);
  }
  return script;
}

}  // namespace halfspace::cli
