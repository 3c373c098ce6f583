// SPDX-License-Identifier: Apache-2.0
// halfspace stability
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/plots/gnuplot.hpp"
#include "model/formats/configuration.hpp"
#include "ref/error.hpp"
#include "study/stability/stability.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

using model::PlaneErrors;
using model::PlaneMethod;
using model::StabilityPoint;
using model::StabilityStudy;

struct StabilityOptions {
  std::string config = "high", out, json;
  model::StabilityOptions study;
};

struct Channel {
  const char* name;
  PlaneErrors StabilityPoint::*errors;
  int bits;
  double bound;
};

std::vector<Channel> channels_of(const Config& config, const StabilityStudy& study) {
  std::vector<Channel> channels;
  if (has_depth(config)) channels.push_back({"depth", &StabilityPoint::depth, config.depth_bits, study.depth_bound});
  if (is_gouraud(config)) {
    channels.push_back({"colour", &StabilityPoint::colour, config.colour_bits, study.colour_bound});
  }
  return channels;
}

Json json_of(const std::vector<StabilityPoint>& points, const std::vector<Channel>& channels) {
  Json list = Json::array();
  for (const StabilityPoint& p : points) {
    Json one = {{"log2", p.log2}, {"triangles", p.triangles}, {"pixels", p.pixels}, {"longest_edge_px", p.longest}};
    for (const Channel& c : channels) {
      for (int m = 0; m < model::kPlaneMethods; ++m) {
        one[c.name][model::plane_method_name(PlaneMethod(m))] = {{"largest_lsb", (p.*c.errors).largest[m]},
                                                                 {"beyond_half_lsb", (p.*c.errors).beyond[m]}};
      }
    }
    list.push_back(std::move(one));
  }
  return list;
}

std::string csv_of(const StabilityStudy& study, const std::vector<Channel>& channels) {
  std::string text = "study,log2,triangles,pixels,longest_edge_px,channel,method,largest_lsb,pixels_beyond_half_lsb\n";
  for (const auto& [name, points] : {std::pair("aspect", &study.aspect), std::pair("size", &study.size)}) {
    for (const StabilityPoint& p : *points) {
      for (const Channel& c : channels) {
        for (int m = 0; m < model::kPlaneMethods; ++m) {
          text += fmt::format("{},{},{},{},{:.3f},{},\"{}\",{:.9g},{}\n", name, p.log2, p.triangles, p.pixels,
                              p.longest, c.name, model::plane_method_name(PlaneMethod(m)), (p.*c.errors).largest[m],
                              (p.*c.errors).beyond[m]);
        }
      }
    }
  }
  return text;
}

void print_table(const char* what, const std::vector<StabilityPoint>& points, const std::vector<Channel>& channels) {
  fmt::print("\n{:>12}", "");
  for (const Channel& c : channels) fmt::print("   {:<44}", fmt::format("{} of {} bits", c.name, c.bits));
  fmt::print("\n{:>12}", what);
  for (std::size_t n = 0; n < channels.size(); ++n) {
    fmt::print("   {:>10} {:>10} {:>10} {:>10} ", "kernels", "origin", "vertex", "saturate");
  }
  fmt::print("\n");
  for (const StabilityPoint& p : points) {
    if (p.triangles == 0) continue;
    fmt::print("{:>12}", fmt::format("2^{}", p.log2));
    for (const Channel& c : channels) {
      fmt::print("  ");
      for (const double error : (p.*c.errors).largest) fmt::print(" {:>10.4g}", error);
      fmt::print(" ");
    }
    fmt::print("\n");
  }
}

// A panel a channel: the largest errors over log2 of what was varied. An error of 0 has no place on a logarithmic axis:
// it stands on the lower border.
std::string plot_script(const std::string& title, const char* axis, const std::vector<StabilityPoint>& points,
                        const std::vector<Channel>& channels) {
  constexpr double kLowerBorder = 1e-6;
  constexpr const char* kStyles[model::kPlaneMethods] = {
      "lc rgb '#0b5fa5' lw 3 pt 7 ps 0.7", "lc rgb '#c0392b' lw 1.5 pt 4 ps 0.7", "lc rgb '#e08e0b' lw 1.5 pt 6 ps 0.7",
      "lc rgb '#7f8c8d' lw 1.5 pt 2 ps 0.6"};
  constexpr PlaneMethod kFrontLast[] = {model::kFloatFromOrigin, model::kFloatFromVertex, model::kSaturatedGradients,
                                        model::kKernelPlane};
  std::string script = fmt::format(
      "set terminal pngcairo size {},600 font 'sans,11' background rgb 'white'\n"
      "set multiplot layout 1,{} title {} font ',14' margins 0.075,0.98,0.24,0.86 spacing 0.09,0\n"
      "set logscale y\nset format y '10^{{%T}}'\nset grid xtics ytics lt 1 lw 0.5 lc rgb '#cccccc'\nset xlabel {}\n"
      "set ylabel 'largest error, LSB (0 on the lower border)'\nset format x '2^{{%g}}'\n"
      "set key at screen 0.5,0.01 center bottom maxrows 2 samplen 3\n",
      channels.size() > 1 ? 1280 : 760, channels.size(), gnuplot_quoted(title), gnuplot_quoted(axis));
  for (std::size_t n = 0; n < channels.size(); ++n) {
    const Channel& c = channels[n];
    script += fmt::format("$data{} << EOD\n", n);
    for (const StabilityPoint& p : points) {
      if (p.triangles == 0) continue;
      script += fmt::format("{}", p.log2);
      for (const double error : (p.*c.errors).largest) script += fmt::format(" {:.9g}", std::max(error, kLowerBorder));
      script += '\n';
    }
    script += fmt::format("EOD\nset title '{} of {} bits'\nset yrange [{}:{}]\n", c.name, c.bits, kLowerBorder,
                          std::ldexp(4, c.bits));
    script += fmt::format("set xrange [{}:{}]\n", points.front().log2 - 0.5, points.back().log2 + 0.5);
    std::string plots;
    for (const PlaneMethod m : kFrontLast) {
      plots += fmt::format("$data{} using 1:{} with linespoints {} title '{}', \\\n", n, m + 2, kStyles[m],
                           model::plane_method_name(m));
    }
    script += fmt::format(
        "plot {}{} with lines dt 2 lw 2 lc rgb '#0b5fa5' title 'proved bound of the kernels', \\\n"
        "0.5 with lines dt 3 lw 1.5 lc rgb 'black' title '½ LSB'\nunset key\n",
        plots, c.bound);
  }
  return script + "unset multiplot\n";
}

void study_stability(const StabilityOptions& options) {
  const model::Configuration configuration = model::find_configuration(options.config);
  const Config config = configuration.config();
  if (!has_planes(config)) {
    throw ref::Error(fmt::format("configuration {} has neither depth nor Gouraud planes: choose one that has",
                                 configuration.name()));
  }
  model::StabilityOptions study_options = options.study;
  Progress progress("stability " + configuration.name());
  study_options.progress = [&](std::size_t done, std::size_t total) { progress.tell(done, total); };
  const StabilityStudy study = model::stability_study(config, study_options);
  const std::vector<Channel> channels = channels_of(config, study);

  fmt::print("stability {}: largest error of planes before rounding, in LSB, {} triangles a row\n",
             configuration.name(), study_options.triangles);
  print_table("aspect ratio", study.aspect, channels);
  if (study.reachable < study_options.largest_aspect) {
    fmt::print("beyond 2^{} the grid of {} has no triangle that covers a pixel centre\n", study.reachable,
               configuration.name());
  }
  print_table("size, px", study.size, channels);
  for (const Channel& c : channels) fmt::print("proved bound of the kernels for {}: {:.4g} LSB\n", c.name, c.bound);

  Json json = {{"format", "halfspace-stability 1"},
               {"config", configuration.name()},
               {"seed", study_options.seed},
               {"triangles", study_options.triangles},
               {"reachable_aspect_log2", study.reachable}};
  for (const Channel& c : channels) json["bound_lsb"][c.name] = c.bound;
  json["aspect"] = json_of(study.aspect, channels);
  json["size"] = json_of(study.size, channels);
  write_json(options.json, json);
  if (options.out.empty()) return;

  model::StagedFolder staged(options.out);
  staged.write("stability.csv", csv_of(study, channels));
  staged.write("stability.json", json.dump(1) + "\n");
  staged.commit();
  if (!gnuplot_is_installed()) {
    throw ref::Error(
        fmt::format("gnuplot is not installed, so there are no pictures; the numbers are in {}: install "
                    "gnuplot-nox",
                    options.out));
  }
  const std::string title = "Configuration " + configuration.name() + ": error of planes before rounding, by ";
  const auto draw = [&](const char* name, const std::string& script) {
    staged.write(name, drawn_by_gnuplot(script, options.out + "/" + name));
  };
  draw("stability_aspect.png",
       plot_script(title + "aspect ratio", "aspect ratio: length / width", study.aspect, channels));
  draw("stability_size.png", plot_script(title + "size", "side of the bounding box, pixels", study.size, channels));
  staged.commit();
  fmt::print("stability.csv, stability.json, stability_aspect.png and stability_size.png in {}\n", options.out);
}

}  // namespace

void add_stability(CLI::App& app, int&) {
  auto options = std::make_shared<StabilityOptions>();
  CLI::App* command = app.add_subcommand("stability", "error of planes against the shape and size of triangles");
  command->footer(
      "  halfspace stability --config low --out stability    CSV, JSON and two plots\n"
      "Depth and colour planes before rounding, against exact arithmetic, at covered pixel centres: the kernels\n"
      "beside float32 planes from the origin of the frame and from a vertex, and beside fixed point whose gradients\n"
      "saturate.\n");
  command->add_option("--config", options->config, "low, middle, high, or a .toml file")->capture_default_str();
  command->add_option("--triangles", options->study.triangles, "of each aspect ratio and size")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000000));
  command->add_option("--aspect", options->study.largest_aspect, "log2 of the largest aspect ratio")
      ->capture_default_str()
      ->check(CLI::Range(0, 60));
  command->add_option("--seed", options->study.seed, "of the triangles")->capture_default_str();
  add_output_folder(command, "--out", options->out, "folder for stability.csv, .json and two pictures");
  add_json(command, options->json);
  command->callback([options] { study_stability(*options); });
}

}  // namespace halfspace::cli
