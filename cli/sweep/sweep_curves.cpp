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
  static const Axis colour_largest{"colour_largest_lsb", "largest error of a colour, LSB of 8", Scale::kLogarithmic};
  static const Axis memory{"memory_bits", "bits of all memories", Scale::kFromZero};
  // Of frames between key frames, against these with nothing rounded.
  static const Axis rendered{"psnr_db", "PSNR against the frames as rendered, dB", Scale::kFree};
  static const Axis unrounded{"reference_psnr_db", "PSNR against the reference, dB", Scale::kFree};
  static const Axis wrong_pixels{"wrong_pixels", "pixels off by more than 16 LSB, worst frame", Scale::kLogarithmic};
  static const std::vector<Axis> motion = {rendered, unrounded, wrong_pixels, bytes, lut};
  static const std::vector<Axis> choice = {psnr, wrong, colour_rms, cycles, bytes, memory, lut};
  static const std::vector<Panels> all = {
      {"subpixel_bits", "sub-pixel bits f", {psnr, wrong, shimmer, depth_rms, lut}},
      {"range_bits", "range bits", {psnr, wrong, cycles, lut}},
      {"depth_bits", "depth bits", {psnr, wrong, depth_rms, bytes, lut}},
      {"colour_bits", "colour bits", {psnr, colour_rms, shimmer, lut}},
      {"reciprocal_bits", "reciprocal bits r", {depth_wrong, depth_stored, cycles, lut}},
      {"depth_fraction", "fraction bits of depth gradients g", {depth_wrong, depth_stored, lut}},
      {"colour_fraction", "fraction bits of colour gradients g", {colour_wrong, colour_stored, lut}},
      {"lanes", "lanes", {cycles, bytes, lut}},
      {"normal_bits", "fraction bits of normals p", {psnr, colour_rms, colour_largest, lut}},
      {"normal_fraction", "fraction bits of gradients of normals g", {psnr, colour_rms, colour_largest, bytes, lut}},
      {"gloss", "largest exponent of a highlight", {psnr, colour_rms, colour_largest, lut}},
      {"lights", "lights that are built", {psnr, colour_rms, lut}},
      {"texels", "texels of the texture memory", {psnr, colour_rms, colour_largest, memory, lut}},
      {"coordinate_bits", "bits of a texture coordinate b", {psnr, colour_rms, colour_largest, bytes, lut}},
      {"coordinate_fraction",
       "fraction bits of gradients of coordinates g",
       {psnr, colour_rms, colour_largest, bytes, lut}},
      {"vector_range", "range of a vector, bits of pixels", motion},
      {"vector_fraction", "fraction bits of a vector", motion},
      {"weight_bits", "bits of weights", motion},
      {"face_bits", "bits of the number of a face", motion},
      {"samples", "samples of a pixel each way", motion},
      {"relight", "differences of light", motion},
      {"filter", "filter of key frames", motion},
      {kKeys, "frames made for each key frame", motion},
      {"shading", "shading", choice},
      {"texture", "filter of textures", choice},
      {"mapping", "mapping of coordinates", choice},
      {"architecture", "architecture", choice}};
  return all;
}

// Of a sweep of motion, what a number buys is told of the frames in between.
std::vector<Axis> axes_of(const Sweep& sweep, const Panels& found) {
  const std::vector<Axis>& motion =
      std::find_if(panels().begin(), panels().end(), [](const Panels& p) { return p.key == std::string(kKeys); })->axes;
  return sweep.motion ? motion : found.axes;
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

std::string base_value(const Sweep& sweep, const std::string& key) {
  const Config base = base_numbers(sweep.input.choice);
  return key == kKeys ? "1" : model::find_field(key)->text(base);
}

Along rows_along(const Sweep& sweep, const std::vector<Json>& rows, const std::string& key) {
  std::map<std::string, std::string> reference;
  Along along;
  for (const Variation& variation : sweep.variations) {
    if (variation.key == key) continue;
    std::string now = base_value(sweep, variation.key);
    const auto& values = variation.values;
    if (!sweep.input.choice.star && std::find(values.begin(), values.end(), now) == values.end()) {
      now = values.front();
      along.instead += fmt::format(", {} = {}", variation.key, now);
    }
    reference[variation.key] = now;
  }
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const SweepConfig& config = sweep.configs[n % sweep.configs.size()];
    const bool of_sweep = !config.asked.empty() || config.base;
    bool same = of_sweep && rows[n]["refused"].is_null();
    for (const auto& [other, value] : reference) {
      const auto asked = config.asked.find(other);
      same = same && (asked == config.asked.end() ? base_value(sweep, other) : asked->second) == value;
    }
    if (same) along.rows.push_back(&rows[n]);
  }
  return along;
}

// Where a row stands along x: a number, or the place of a word among the values.
std::optional<double> place(const Json& row, const Variation& variation) {
  if (!variation.is_choice) return number(row, variation.key);
  const auto& values = variation.values;
  const auto at = std::find(values.begin(), values.end(), row[variation.key].get<std::string>());
  return at == values.end() ? std::nullopt : std::optional<double>(double(at - values.begin()));
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

void draw_panel(const Sweep& sweep, PanelScript& script, const std::vector<const Json*>& rows,
                const Variation& variation, const Axis& axis) {
  const std::string column = column_name(sweep, axis.column);
  const Extent extent = extent_of(rows, column);
  const auto [unit, unit_name] = unit_of(axis, extent);
  std::string plot;
  for (std::size_t s = 0; s < sweep.scenes.size(); ++s) {
    std::map<double, double> curve;
    for (const Json* row : rows) {
      const auto x = place(*row, variation), y = number(*row, column);
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
std::string x_axis(const Variation& variation, double first, double last, std::optional<double> base) {
  const model::ConfigField* field = model::find_field(variation.key);
  if (field && field->is_number() && field->allowed.is_power && first > 0) return "set logscale x 2";
  if (variation.is_choice) {
    std::string text = "set xrange [-0.3:" + fmt::format("{}", last + 0.3) + "]\nset xtics (";
    for (std::size_t n = 0; n < variation.values.size(); ++n)
      text += fmt::format("{}{} {}", n ? ", " : "", gnuplot_quoted(variation.values[n]), n);
    return text + ")";
  }
  std::string text =
      fmt::format("set xrange [{}:{}]\nset xtics {}", first - 0.3, last + 0.3, last - first > 12 ? 2 : 1);
  if (base && *base >= first && *base <= last) {
    text +=
        fmt::format("\nset arrow 1 from first {0}, graph 0 to first {0}, graph 1 nohead dt 3 lc rgb '#777777'", *base);
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
    if (const auto value = place(*row, variation)) values.push_back(*value);
  }
  if (found == panels().end() || values.empty()) return std::nullopt;
  const auto [first, last] = std::minmax_element(values.begin(), values.end());
  if (*first == *last) return std::nullopt;
  std::vector<Axis> axes;
  for (const Axis& axis : axes_of(sweep, *found)) {
    if (!column_name(sweep, axis.column).empty()) axes.push_back(axis);
  }
  const int count = int(axes.size()), columns = count == 4 ? 2 : std::min(count, 3);
  const std::string title =
      fmt::format("{}; all else as in {}{}{}", found->title, short_name(sweep.input.choice.config), drawn.instead,
                  one_size(sweep) ? ", frame " + size_of(sweep.scenes[0]) : "");
  PanelScript script(key + ".png", title, columns, (count + columns - 1) / columns, 400, 320);
  const auto base = variation.is_choice ? std::nullopt : std::optional<double>(std::stod(base_value(sweep, key)));
  script.line(fmt::format("set xlabel {}", gnuplot_quoted(found->title)));
  script.line(x_axis(variation, *first, *last, base));
  for (const Axis& axis : axes) {
    // One key, in the first panel.
    script.line(&axis != &axes[0]            ? "unset key"
                : axis.scale == Scale::kFree ? "set key bottom right"
                                             : "set key top right");
    draw_panel(sweep, script, along, variation, axis);
  }
  return script;
}

}  // namespace halfspace::cli
