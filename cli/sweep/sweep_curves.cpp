// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/plots/gnuplot.hpp"
#include "cli/sweep/sweep_plots.hpp"
#include "cli/sweep/sweep_table.hpp"

namespace halfspace::cli {
namespace {

// The last shows 0 on a line of its own.
enum class Scale { kFromZero, kFromHalf, kFree, kLogarithmic };

// What a measure is called above its panel.
struct Axis {
  const char* column;
  const char* title;
  Scale scale;
};

// The measures that tell what a number buys, the costs last. `lut` stands for the column of the first target.
struct Panels {
  const char* key;
  const char* title;
  std::vector<Axis> axes;
};
const std::vector<Panels>& panels() {
  static const Axis psnr{"psnr_db", "PSNR against the ideal, dB", Scale::kFree};
  static const Axis wrong{"wrong_index_pixels", "pixels of a wrong face", Scale::kLogarithmic};
  static const Axis shimmer{"shimmer_rms_lsb", "shimmer, RMS LSB of 8", Scale::kLogarithmic};
  static const Axis depth_rms{"depth_rms_ppm", "depth, RMS error in millionths of full scale", Scale::kLogarithmic};
  static const Axis depth_wrong{"depth_misrounded_share", "share of depths not rounded to nearest",
                                Scale::kLogarithmic};
  static const Axis depth_stored{"stored_depth_largest_lsb", "largest error of a stored depth, LSB", Scale::kFromHalf};
  static const Axis colour_rms{"colour_rms_lsb", "colour, RMS LSB of 8", Scale::kLogarithmic};
  static const Axis colour_wrong{"colour_misrounded_share", "share of colours not rounded to nearest",
                                 Scale::kLogarithmic};
  static const Axis colour_stored{"stored_colour_largest_lsb", "largest error of a stored colour, LSB of 8",
                                  Scale::kFromHalf};
  static const Axis cycles{"cycles", "cycles a frame", Scale::kFromZero};
  static const Axis bytes{"bytes", "bytes a frame, all memories", Scale::kFromZero};
  static const Axis lut{"lut", "LUTs of the pipeline", Scale::kFromZero};
  static const std::vector<Panels> all = {
      {"subpixel_bits", "sub-pixel bits f", {psnr, wrong, shimmer, depth_rms, lut}},
      {"range_bits", "range bits", {psnr, wrong, cycles, lut}},
      {"depth_bits", "depth bits", {psnr, wrong, depth_rms, bytes, lut}},
      {"colour_bits", "colour bits", {psnr, colour_rms, shimmer, lut}},
      {"reciprocal_bits", "reciprocal bits r", {depth_wrong, depth_stored, cycles, lut}},
      {"depth_fraction", "fraction bits of depth gradients g", {depth_wrong, depth_stored, lut}},
      {"colour_fraction", "fraction bits of colour gradients g", {colour_wrong, colour_stored, lut}},
      {"lanes", "lanes", {cycles, bytes, lut}}};
  return all;
}

// Empty where there is no area.
std::string column_name(const Sweep& sweep, const std::string& column) {
  return column == "lut" ? lut_column(sweep) : column;
}

// What is drawn along `key`: the rows that differ from the base in it alone. A number that was varied without the
// base's value stands at its first, which the picture has to say.
struct Along {
  std::vector<const Json*> rows;
  std::string instead;  // ", f = 1" for each of those
};

Along rows_along(const Sweep& sweep, const std::vector<Json>& rows, const std::string& key) {
  Json reference = to_json(base_numbers(sweep.input.choice));
  Along along;
  for (const Variation& variation : sweep.variations) {
    if (sweep.input.choice.star || variation.key == key || variation.key == "shading") continue;
    const std::string now = std::to_string(reference[variation.key].get<int>());
    const auto& values = variation.values;
    if (std::find(values.begin(), values.end(), now) != values.end()) continue;
    reference[variation.key] = std::stoi(values.front());
    along.instead += fmt::format(", {} = {}", variation.key, values.front());
  }
  for (const Json& row : rows) {
    bool same = row["refused"].is_null();
    for (const auto& item : reference.items()) {
      const std::string column = item.key() == "width" || item.key() == "height" ? "largest_" + item.key() : item.key();
      same = same && (item.key() == key || row[column] == item.value());
    }
    if (same) along.rows.push_back(&row);
  }
  return along;
}

std::string size_of(const SweepScene& scene) { return fmt::format("{}x{}", scene.width, scene.height); }

bool one_size(const Sweep& sweep) {
  return std::all_of(sweep.scenes.begin(), sweep.scenes.end(),
                     [&](const SweepScene& scene) { return size_of(scene) == size_of(sweep.scenes[0]); });
}

struct Extent {
  double least = 0, largest = 0;  // above 0
  bool zero = false;
  // Where a logarithmic scale shows 0: a decade below the least.
  double floor() const { return least > 0 ? std::pow(10, std::floor(std::log10(least)) - 1) : 0; }
};

Extent extent_of(const std::vector<const Json*>& rows, const std::string& column) {
  Extent extent;
  for (const Json* row : rows) {
    const auto value = number(*row, column);
    if (!value) continue;
    extent.zero = extent.zero || *value == 0;
    if (*value > 0) extent.least = extent.least == 0 ? *value : std::min(extent.least, *value);
    extent.largest = std::max(extent.largest, *value);
  }
  return extent;
}

// What large numbers are told in.
std::pair<double, const char*> unit_of(const Axis& axis, const Extent& extent) {
  if (axis.scale != Scale::kFromZero || extent.largest < 1e4) return {1, ""};
  return extent.largest < 1e6 ? std::make_pair(1e3, ", thousands") : std::make_pair(1e6, ", millions");
}

std::string scale_of(const Axis& axis, const Extent& extent) {
  const std::string ticks = "set format y '%g'\nset ytics autofreq\n";
  if (axis.scale == Scale::kLogarithmic && extent.least > 0) {
    if (!extent.zero) return ticks + "set logscale y\nset autoscale y\n";
    return ticks + fmt::format("set logscale y\nset yrange [{0}:*]\nset ytics add ('0' {0})\n", extent.floor());
  }
  if (axis.scale == Scale::kFree) return ticks + "unset logscale y\nset yrange [*:*]\n";
  if (axis.scale == Scale::kFromHalf) return ticks + "unset logscale y\nset yrange [*<0.5:*]\n";
  return ticks + "unset logscale y\nset yrange [0:1<*]\n";
}

void draw_panel(const Sweep& sweep, PanelScript& script, const std::vector<const Json*>& rows, const std::string& key,
                const Axis& axis) {
  const std::string column = column_name(sweep, axis.column);
  const Extent extent = extent_of(rows, column);
  const auto [unit, unit_name] = unit_of(axis, extent);
  std::string plot;
  for (std::size_t s = 0; s < sweep.scenes.size(); ++s) {
    std::map<double, double> curve;
    for (const Json* row : rows) {
      const auto x = number(*row, key), y = number(*row, column);
      if ((*row)["scene"] != sweep.scenes[s].name || !x || !y) continue;
      curve[*x] = axis.scale == Scale::kLogarithmic && *y == 0 ? extent.floor() : *y;
    }
    std::string points;
    for (const auto& [x, y] : curve) points += fmt::format("{} {}\n", x, y / unit);
    if (points.empty()) continue;
    const SweepScene& scene = sweep.scenes[s];
    const std::string label = short_name(scene.name) + (one_size(sweep) ? "" : ", " + size_of(scene));
    plot += fmt::format("{}{} with linespoints pt 7 ps 0.7 lc rgb '{}' title {}", plot.empty() ? "plot " : ", ",
                        script.data(points), curve_colour(s), gnuplot_quoted(label));
  }
  script.line("set title " + gnuplot_quoted(std::string(axis.title) + unit_name));
  script.line(scale_of(axis, extent) + (plot.empty() ? "set multiplot next" : plot));
}

// The numbers along x, with the base's marked.
std::string x_axis(const std::string& key, double first, double last, double base) {
  if (key == "lanes") return "set logscale x 2";
  std::string text =
      fmt::format("set xrange [{}:{}]\nset xtics {}", first - 0.3, last + 0.3, last - first > 12 ? 2 : 1);
  if (base >= first && base <= last) {
    text +=
        fmt::format("\nset arrow 1 from first {0}, graph 0 to first {0}, graph 1 nohead dt 3 lc rgb '#777777'", base);
  }
  return text;
}

}  // namespace

std::optional<PanelScript> curves_plot(const Sweep& sweep, const std::vector<Json>& rows, const Variation& variation) {
  const std::string& key = variation.key;
  const auto found = std::find_if(panels().begin(), panels().end(), [&](const Panels& p) { return p.key == key; });
  const Along drawn = rows_along(sweep, rows, key);
  const std::vector<const Json*>& along = drawn.rows;
  std::vector<double> values;
  for (const Json* row : along) {
    if (const auto value = number(*row, key)) values.push_back(*value);
  }
  if (found == panels().end() || values.empty()) return std::nullopt;
  const auto [first, last] = std::minmax_element(values.begin(), values.end());
  if (*first == *last) return std::nullopt;
  std::vector<Axis> axes;
  for (const Axis& axis : found->axes) {
    if (!column_name(sweep, axis.column).empty()) axes.push_back(axis);
  }
  const int count = int(axes.size()), columns = count == 4 ? 2 : std::min(count, 3);
  const std::string title = fmt::format("{}; all else as in {}{}{}", found->title, sweep.input.choice.config,
                                        drawn.instead, one_size(sweep) ? ", frame " + size_of(sweep.scenes[0]) : "");
  PanelScript script(key + ".png", title, columns, (count + columns - 1) / columns, 400, 320);
  const Json base = to_json(base_numbers(sweep.input.choice));
  script.line(fmt::format("set xlabel {}", gnuplot_quoted(found->title)));
  script.line(x_axis(key, *first, *last, base[key].get<double>()));
  for (const Axis& axis : axes) {
    // One key, in the first panel.
    script.line(&axis != &axes[0]            ? "unset key"
                : axis.scale == Scale::kFree ? "set key bottom right"
                                             : "set key top right");
    draw_panel(sweep, script, along, key, axis);
  }
  return script;
}

}  // namespace halfspace::cli
