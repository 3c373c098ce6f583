// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_plots.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "cli/plots/gnuplot.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {

std::vector<std::string> draw_plots(const Sweep& sweep, const std::vector<Json>& rows) {
  const std::string& out = sweep.input.out;
  if (!gnuplot_is_installed()) {
    throw ref::Error(fmt::format(
        "gnuplot is not installed, so there are no plots; the numbers are in {}: install gnuplot-nox, and run the same "
        "command again",
        out));
  }
  std::vector<std::optional<PanelScript>> scripts;
  for (const Variation& variation : sweep.variations) scripts.push_back(curves_plot(sweep, rows, variation));
  scripts.push_back(front_plot(sweep, rows));
  scripts.push_back(map_plot(sweep, rows));
  std::vector<std::string> written;
  model::StagedFolder staged(out);
  for (const auto& script : scripts) {
    if (!script) continue;
    written.push_back((std::filesystem::path(out) / script->name()).string());
    staged.write(script->name(), drawn_by_gnuplot(script->text(), written.back()));
  }
  staged.commit();
  return written;
}

}  // namespace halfspace::cli
