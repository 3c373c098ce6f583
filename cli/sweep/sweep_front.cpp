// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include "cli/plots/gnuplot.hpp"
#include "cli/sweep/sweep_plots.hpp"
#include "cli/sweep/sweep_table.hpp"

namespace halfspace::cli {
namespace {

// Few enough tics that their numbers, which may be long, stand apart.
std::string x_axis(double first, double last) {
  if (last > 8 * first) {
    return fmt::format("set logscale x\nset xrange [{}:{}]\nset xtics autofreq\nset format x '%.0s%c'", first / 2,
                       last * 2);
  }
  if (first >= last) {
    return fmt::format("unset logscale x\nset xrange [{}:{}]\nset xtics autofreq\nset format x '%.0f'", 0.9 * first,
                       1.1 * first);
  }
  const double quarter = (last - first) / 4, decade = std::pow(10, std::floor(std::log10(quarter)));
  const double step = std::max(1.0, decade * (quarter <= 2 * decade ? 2 : quarter <= 5 * decade ? 5 : 10));
  const char* format = step < 1000 ? "%.0f" : step < 1e6 && last >= 1e6 ? "%.2s%c" : "%.0s%c";
  return fmt::format("unset logscale x\nset xrange [*:*]\nset xtics {}\nset format x '{}'", step, format);
}

void draw_front(PanelScript& script, const std::vector<Json>& rows, const std::string& scene, const std::string& cost,
                const std::string& flag, const char* title, bool motion) {
  std::string other, front, base;
  std::vector<std::string> named;
  std::map<double, double> line;
  double first = std::numeric_limits<double>::infinity(), last = 0;
  for (const Json& row : rows) {
    const auto x = number(row, cost), y = number(row, "psnr_db");
    if (row["scene"] != scene || !x || !y || !row[flag].is_boolean()) continue;
    first = std::min(first, *x), last = std::max(last, *x);
    const std::string at = fmt::format("{} {}", *x, *y);
    (row[flag].get<bool>() ? front : other) += at + "\n";
    if (row[flag].get<bool>()) line[*x] = *y;
    if (row["named"].is_string()) named.push_back(fmt::format("{} {}\n", at, row["named"].get<std::string>()));
    else if (row["base"].get<bool>()) base += at + " base\n";
  }
  std::string steps;
  for (const auto& [x, y] : line) steps += fmt::format("{} {}\n", x, y);
  script.line(
      fmt::format("set title {}\nset ylabel 'PSNR against the {}, dB'\nset key below center horizontal samplen 1",
                  gnuplot_quoted(short_name(scene) + ": " + title), motion ? "frames as rendered" : "ideal"));
  if (last == 0) return script.line("set multiplot next");  // equal to what they are held against, or not measured
  script.line(x_axis(first, last));
  std::string plot;
  const auto add = [&](const std::string& data, const std::string& style) {
    if (!data.empty()) plot += (plot.empty() ? "plot " : ", ") + script.data(data) + " " + style;
  };
  add(other, "with points pt 6 ps 0.8 lc rgb '#999999' title 'other'");
  add(steps, "with steps lc rgb '#1f6fb4' notitle");
  add(front, "with points pt 7 ps 0.9 lc rgb '#1f6fb4' title 'Pareto front'");
  // Around their points, as they may lie on each other.
  constexpr const char* kPlaces[] = {"left offset 1,-0.9", "right offset -1,0.7", "left offset 1,0.7"};
  for (std::size_t n = 0; n < named.size(); ++n) {
    add(named[n], fmt::format("with points pt 4 ps 1.7 lc rgb '#d95f02' {}", n == 0 ? "title 'named'" : "notitle"));
    add(named[n], fmt::format("using 1:2:3 with labels {} tc rgb '#d95f02' notitle", kPlaces[n % 3]));
  }
  add(base, "with points pt 8 ps 1.7 lc rgb '#d95f02' title 'base'");
  script.line(plot.empty() ? "set multiplot next" : plot);
}

}  // namespace

std::optional<PanelScript> front_plot(const Sweep& sweep, const std::vector<Json>& rows) {
  if (sweep.configs.size() < 2) return std::nullopt;
  const std::string lut = lut_column(sweep);
  struct Cost {
    std::string column, flag;
    const char* title;
  };
  std::vector<Cost> costs;
  costs = {{"memory_bits", "pareto_memory", "bits of the memories of a frame"},
           {"bytes", "pareto_bytes", "bytes read and written a frame"}};
  if (lut.empty()) costs.push_back({"multiplier_bits", "pareto_multiplier", "bits that the multipliers add up"});
  else costs.push_back({lut, "pareto_lut", "LUTs of the pipeline"});
  costs.push_back({"cycles", "pareto_cycles", sweep.motion ? "cycles of motion_compensate" : "cycles a frame"});
  const auto is_known = [&](const Cost& cost) {
    return std::any_of(rows.begin(), rows.end(), [&](const Json& row) { return number(row, cost.column).has_value(); });
  };
  costs.erase(std::remove_if(costs.begin(), costs.end(), std::not_fn(is_known)), costs.end());
  if (costs.empty()) return std::nullopt;
  PanelScript script("front.png", "accuracy and what it takes", int(costs.size()), int(sweep.scenes.size()),
                     costs.size() > 3   ? 440
                     : costs.size() > 2 ? 480
                                        : 600,
                     420);
  script.line("set offsets graph 0.1, graph 0.14, graph 0.06, graph 0.08");
  for (const SweepScene& scene : sweep.scenes) {
    for (const Cost& cost : costs)
      draw_front(script, rows, scene.name, cost.column, cost.flag, cost.title, sweep.motion);
  }
  return script;
}

}  // namespace halfspace::cli
