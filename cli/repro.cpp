// SPDX-License-Identifier: Apache-2.0
// halfspace repro
#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/repro/repro_frames.hpp"
#include "cli/repro/repro_plots.hpp"
#include "cli/repro/repro_static.hpp"
#include "ref/error.hpp"
#include "study/papers/index_rendering.hpp"
#include "study/papers/lighting_cost.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

using model::HardwareLevel;
using model::WidePixel;
using ref::Architecture;
using ref::ShadingMode;

struct ReproOptions {
  std::vector<std::string> scenes;
  std::string out, json;
};

// Those of the paper that are free, or stand for them.
const std::vector<std::string> kScenes = {"polyhedron", "teapot", "castle"};

std::string size_name(int width, int height) { return fmt::format("{}x{}", width, height); }
double percent(double part, double whole) { return whole == 0 ? 100 : 100 * part / whole; }

Json bytes_json(const model::BufferBytes& b) {
  return {{"depth_buffer", b.depth},
          {"frame_buffer", b.frame},
          {"pixel_buffer", b.pixel},
          {"index_buffer", b.index},
          {"visibility_database", b.visibility},
          {"shading_database", b.shading},
          {"total", b.total()}};
}

// --- paper A ---

struct Measured {
  std::string scene;
  const HardwareLevel* level;
  int width, height;
  ShadingMode mode;
  model::FourRates rates;
};

std::vector<Measured> measure_all(const ReproOptions& options) {
  std::vector<Measured> all;
  Progress progress("repro A: pictures");
  std::size_t total = 0;
  for (const HardwareLevel& level : model::hardware_levels()) total += level.sizes.size();
  total *= options.scenes.size() * std::size(ref::kShadingModes);
  for (const std::string& name : options.scenes) {
    const ref::Scene scene = ref::load_scene(name);
    for (const HardwareLevel& level : model::hardware_levels()) {
      for (const auto& [width, height] : level.sizes) {
        for (const ShadingMode mode : ref::kShadingModes) {
          all.push_back({name, &level, width, height, mode,
                         model::measure_architectures(scene, level.config, width, height, mode)});
          progress.tell(all.size(), total);
        }
      }
    }
  }
  return all;
}

Json print_lightings(const std::vector<Measured>& all) {
  fmt::print(
      "Lightings, percent of alpha's (the paper: deferred shading saves none with flat and Gouraud, index rendering "
      "10–70 %;\n"
      "with Phong both save 30–95 %)\n\n{:<12} {:>9} {:<8} {:>10} {:>8} {:>8} {:>12}\n",
      "scene", "frame", "shading", "alpha", "beta", "gamma", "delta");
  Json rows = Json::array();
  for (const Measured& m : all) {
    std::array<double, 4> share;
    for (std::size_t n = 0; n < 4; ++n)
      share[n] = percent(double(m.rates[n].rates.lightings), double(m.rates[0].rates.lightings));
    fmt::print("{:<12} {:>9} {:<8} {:>10} {:>7.1f}% {:>7.1f}% {:>11.1f}%\n", short_name(m.scene),
               size_name(m.width, m.height), name_of(m.mode), m.rates[0].rates.lightings, share[1], share[2], share[3]);
    Json row = {{"scene", m.scene},
                {"level", m.level->config},
                {"width", m.width},
                {"height", m.height},
                {"shading", name_of(m.mode)}};
    for (std::size_t n = 0; n < 4; ++n) row[name_of(ref::kArchitectures[n])] = all_rates(m.rates[n].rates);
    rows.push_back(std::move(row));
  }
  return rows;
}

constexpr const char* kWideNames[] = {"a copy of the planes (the paper's direct method)",
                                      "the interpolated colour alone"};

Json print_sizes() {
  Json rows = Json::array();
  for (const WidePixel wide : {WidePixel::kPlanes, WidePixel::kInterpolated}) {
    fmt::print("\nBuffers, kB; a wide pixel of beta: {}\n\n{:<8} {:>9} {:<8} {:>9} {:>9} {:>9} {:>9}   {}\n",
               kWideNames[int(wide)], "level", "frame", "shading", "alpha", "beta", "gamma", "delta",
               "gamma, delta against beta (the paper: 70 % less)");
    for (const HardwareLevel& level : model::hardware_levels()) {
      for (const auto& [width, height] : level.sizes) {
        for (const ShadingMode mode : ref::kShadingModes) {
          std::array<double, 4> total;
          Json row = {{"level", level.config},
                      {"width", width},
                      {"height", height},
                      {"shading", name_of(mode)},
                      {"wide_pixel", wide == WidePixel::kPlanes ? "planes" : "interpolated"}};
          for (std::size_t n = 0; n < 4; ++n) {
            const auto bytes = model::buffer_sizes(level, width, height, ref::kArchitectures[n], mode, wide);
            total[n] = bytes.total();
            row[name_of(ref::kArchitectures[n])] = bytes_json(bytes);
          }
          fmt::print("{:<8} {:>9} {:<8} {:>9.0f} {:>9.0f} {:>9.0f} {:>9.0f}   {:+.0f} %, {:+.0f} %\n", level.config,
                     size_name(width, height), name_of(mode), total[0] / 1e3, total[1] / 1e3, total[2] / 1e3,
                     total[3] / 1e3, percent(total[2], total[1]) - 100, percent(total[3], total[1]) - 100);
          rows.push_back(std::move(row));
        }
      }
    }
  }
  return rows;
}

// A line of bandwidth, MB/s, from the accesses by each architecture.
Json print_bandwidth(const std::string& what, const HardwareLevel& level, int width, int height, ShadingMode mode,
                     WidePixel wide, const std::array<ref::BufferUses, 4>& uses) {
  const model::BufferBits bits = model::buffer_bits(level, mode, wide);
  std::array<double, 4> rate;
  Json row = {{"scene", what},
              {"level", level.config},
              {"width", width},
              {"height", height},
              {"shading", name_of(mode)},
              {"wide_pixel", wide == WidePixel::kPlanes ? "planes" : "interpolated"}};
  double tdbv = 0;
  for (std::size_t n = 0; n < 4; ++n) {
    const auto bytes = model::buffer_traffic(uses[n], bits);
    rate[n] = bytes.total() * level.frames / 1e6;
    if (ref::kArchitectures[n] == Architecture::kGamma) tdbv = bytes.visibility * level.frames / 1e6;
    Json& of = row[name_of(ref::kArchitectures[n])] = bytes_json(bytes);
    of["accesses"] = to_json(uses[n], bits);
  }
  fmt::print("{:<12} {:<7} {:>9} {:<8} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f} {:>8.1f}   {:+.0f} %, {:+.0f} %\n", what,
             level.config, size_name(width, height), name_of(mode), rate[0], rate[1], rate[2], rate[2] - tdbv, rate[3],
             percent(rate[2] - tdbv, rate[1]) - 100, percent(rate[3], rate[1]) - 100);
  return row;
}

Json print_bandwidths(const std::vector<Measured>& all) {
  Json rows = Json::array();
  for (const WidePixel wide : {WidePixel::kPlanes, WidePixel::kInterpolated}) {
    fmt::print(
        "\nBandwidth, MB/s; a wide pixel of beta: {}. TdbV is small enough to be on chip, so gamma stands without it "
        "as well.\n"
        "largest: all triangles of the level visible, {} fragments each, all of which pass.\n\n"
        "{:<12} {:<7} {:>9} {:<8} {:>8} {:>8} {:>8} {:>8} {:>8}   {}\n",
        kWideNames[int(wide)], model::kTrianglePixels, "scene", "level", "frame", "shading", "alpha", "beta", "gamma",
        "- TdbV", "delta", "gamma - TdbV, delta against beta (the paper: 50–70 % less)");
    for (const HardwareLevel& level : model::hardware_levels()) {
      for (const auto& [width, height] : level.sizes) {
        for (const ShadingMode mode : ref::kShadingModes) {
          std::array<ref::BufferUses, 4> uses;
          for (std::size_t n = 0; n < 4; ++n)
            uses[n] = model::largest_uses(level, width, height, ref::kArchitectures[n]);
          rows.push_back(print_bandwidth("largest", level, width, height, mode, wide, uses));
        }
      }
    }
    for (const Measured& m : all) {
      std::array<ref::BufferUses, 4> uses;
      for (std::size_t n = 0; n < 4; ++n) uses[n] = m.rates[n].uses;
      rows.push_back(print_bandwidth(short_name(m.scene), *m.level, m.width, m.height, m.mode, wide, uses));
    }
  }
  return rows;
}

void repro_a(const ReproOptions& options) {
  const std::vector<Measured> all = measure_all(options);
  Json json = {{"paper", "index rendering"}};
  json["lightings"] = print_lightings(all);
  json["sizes"] = print_sizes();
  json["bandwidth"] = print_bandwidths(all);
  write_json(options.json, json);
  if (!options.out.empty()) {
    for (const std::string& picture : plot_index_rendering(json, options.out)) fmt::print("{}\n", picture);
  }
}

// --- paper B ---

void print_model(const std::string& name, const model::TriangleCounts& n) {
  const double dual = double(model::cost_dual(n)), one = double(model::cost_type_1(n)),
               two = double(model::cost_type_2(n));
  fmt::print("{:<22} {:>8} {:>8} {:>8} {:>6.1f}% {:>6.1f}% {:>9.0f}k {:>9.0f}k {:>9.0f}k {:>7.1f}% {:>7.1f}%\n", name,
             n.a, n.b, n.c, percent(double(n.c), double(n.b)), percent(double(n.c), double(n.a)), one / 1e3, two / 1e3,
             dual / 1e3, percent(dual, one), percent(dual, two));
}

Json model_json(const model::TriangleCounts& n) {
  return {{"a", n.a},
          {"b", n.b},
          {"c", n.c},
          {"type_1", model::cost_type_1(n)},
          {"type_2", model::cost_type_2(n)},
          {"dual", model::cost_dual(n)}};
}

void repro_b(const ReproOptions& options) {
  fmt::print(
      "Instructions of the geometry stage by the paper's cost model; a: all triangles, b: face the viewer in the "
      "frame, c: visible\n\n"
      "{:<22} {:>8} {:>8} {:>8} {:>7} {:>7} {:>10} {:>10} {:>10} {:>8} {:>8}\n",
      "320x200", "a", "b", "c", "c/b", "c/a", "type I", "type II", "dual", "/ I", "/ II");
  // As printed: counts of one model, and shares of the other, of which 10,000 triangles are taken.
  constexpr model::TriangleCounts kDolphins{3000, 1451, 1206}, kCastle{10000, 4545, 2000};
  print_model("dolphins, the paper's", kDolphins);
  print_model("castle, the paper's %", kCastle);
  Json json = {{"paper", "dual pipeline"},
               {"printed", {{"dolphins", model_json(kDolphins)}, {"castle", model_json(kCastle)}}},
               {"measured", Json::array()}};
  std::vector<std::pair<std::string, model::LightingCost>> costs;
  for (const std::string& name : options.scenes) {
    costs.emplace_back(name, model::measure_lighting(ref::load_scene(name), "low", 320, 200));
    print_model(short_name(name), costs.back().second.triangles);
  }
  fmt::print(
      "\nTime of our geometry stage, ms, one thread; a corner that triangles share is lit once\n\n"
      "{:<22} {:>10} {:>16} {:>16} {:>22}\n",
      "320x200", "positions", "lighting all b", "lighting c", "corners lit");
  for (const auto& [name, cost] : costs) {
    fmt::print("{:<22} {:>10.3f} {:>16.3f} {:>9.3f} ({:.0f}%) {:>14} of {}\n", short_name(name), cost.positions_ms,
               cost.light_facing_ms, cost.light_visible_ms, percent(cost.light_visible_ms, cost.light_facing_ms),
               cost.corners_visible, cost.corners_facing);
    Json row = model_json(cost.triangles);
    row["scene"] = name;
    row["positions_ms"] = cost.positions_ms;
    row["light_facing_ms"] = cost.light_facing_ms;
    row["light_visible_ms"] = cost.light_visible_ms;
    row["corners_facing"] = cost.corners_facing;
    row["corners_visible"] = cost.corners_visible;
    json["measured"].push_back(std::move(row));
  }
  write_json(options.json, json);
  if (!options.out.empty()) {
    for (const std::string& picture : plot_lighting_cost(json, options.out)) fmt::print("{}\n", picture);
  }
}

}  // namespace

void add_repro(CLI::App& app, int&) {
  CLI::App* command = app.add_subcommand("repro", "the tables of a paper, with our numbers beside the printed ones");
  command->require_subcommand(1);
  command->footer(
      "  halfspace repro A                     index rendering: lightings, buffers and bandwidth of four "
      "architectures\n"
      "  halfspace repro B castle teapot       dual pipeline: instructions and time that deferred lighting saves\n"
      "  halfspace repro C gouraud --frames 11 --size 160x120  frame-rate up-conversion: PSNR of frames that are made, "
      "ten animations\n"
      "  halfspace repro E --objects 300 --moving 5 --frames 10 --full-frames 2 --width 160 --height 120  static "
      "objects "
      "buffer;\n"
      "                                        without these numbers 180 M triangles, and minutes\n"
      "docs/repro.md says what the numbers are.\n");
  const auto add = [&](const char* name, const char* what, void (*run)(const ReproOptions&)) {
    auto options = std::make_shared<ReproOptions>();
    CLI::App* paper = command->add_subcommand(name, what);
    paper->add_option("SCENE", options->scenes, "built-in scenes or mesh files; default: polyhedron teapot castle");
    add_output_folder(paper, "--out", options->out, "folder for the plots");
    add_json(paper, options->json);
    paper->callback([options, run] {
      if (options->scenes.empty()) options->scenes = kScenes;
      if (!options->out.empty()) model::make_folder(options->out);
      run(*options);
    });
  };
  add("A", "index rendering", repro_a);
  add("B", "dual pipeline", repro_b);
  add_repro_frames(command);
  add_repro_static(*command);
}

}  // namespace halfspace::cli
