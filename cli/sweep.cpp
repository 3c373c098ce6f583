// SPDX-License-Identifier: Apache-2.0
// halfspace sweep
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <set>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/scene_source.hpp"
#include "cli/sweep/sweep_measure.hpp"
#include "cli/sweep/sweep_plots.hpp"
#include "cli/sweep/sweep_points.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

struct SweepOptions {
  SweepInput input;
  int jobs = 1, point = 0;
  bool list = false, merge = false;
};

// A line a point: number, file, what it is, whether it is there.
void list_points(const Sweep& sweep) {
  for (std::size_t n = 0; n < sweep.points.size(); ++n) {
    const SweepPoint& point = sweep.points[n];
    fmt::print("{}\t{}\t{}\t{}\t{}\n", n + 1, (std::filesystem::path(sweep.input.out) / point.file).string(),
               point.is_area ? "area" : sweep.scenes[point.scene].name, sweep.configs[point.config].name,
               stored_result(sweep, point).is_null() ? "to do" : "done");
  }
}

int merge(const Sweep& sweep) {
  const std::vector<Json> rows = sweep_rows(sweep);
  write_table(sweep, rows);
  std::set<std::string> refused;
  std::size_t measured = 0;
  for (const Json& row : rows) {
    if (row["refused"].is_null()) ++measured;
    else refused.insert(row["refused"].get<std::string>());
  }
  for (const std::string& reason : refused) fmt::print("not measured: {}\n", reason);
  const std::string csv = (std::filesystem::path(sweep.input.out) / "sweep.csv").string();
  if (measured == 0) throw ref::Error(fmt::format("{}: nothing could be measured: each row says why", csv));
  fmt::print("{}: {} rows, {} measured\n", csv, rows.size(), measured);
  for (const std::string& line : draw_plots(sweep, rows)) fmt::print("{}\n", line);
  return 0;
}

int run(const SweepOptions& options) {
  const Sweep sweep = plan_sweep(options.input);
  if (options.list) {
    list_points(sweep);
    return 0;
  }
  if (options.merge) return merge(sweep);
  if (options.point) {
    if (options.point > int(sweep.points.size())) {
      throw ref::Error(
          fmt::format("--point {}: there are {} points: --list tells them", options.point, sweep.points.size()));
    }
    const SweepPoint& point = sweep.points[std::size_t(options.point) - 1];
    model::make_folder(sweep.input.out);
    if (stored_result(sweep, point).is_null()) compute_point(sweep, point);
    return 0;
  }
  model::make_folder(sweep.input.out);
  const std::vector<std::string> failures = compute_points(sweep, options.jobs);
  if (failures.empty()) return merge(sweep);
  for (const std::string& failure : failures) fmt::print("failed: {}\n", failure);
  throw ref::Error(
      fmt::format("{} of {} points failed: the same command goes on with them", failures.size(), sweep.points.size()));
}

}  // namespace

void add_sweep(CLI::App& app, int& status) {
  auto options = std::make_shared<SweepOptions>();
  SweepInput& input = options->input;
  CLI::App* command =
      app.add_subcommand("sweep", "what accuracy costs: configurations measured on scenes, tables and plots");
  command->footer(
      "  halfspace sweep teapot castle --size 320x200 --vary subpixel_bits=2..11 --out sweep\n"
      "  halfspace sweep teapot --size 320x200 --star --no-named --vary lanes=1,4 --area xilinx --jobs 2 --out area\n"
      "  halfspace sweep teapot --size 160x120 --vary lights=1 --vary shading=gouraud,phong --vary normal_bits=9,13\n"
      "  halfspace sweep cube_fast --size 160x120 --vary texture=nearest,bilinear --vary texels=64,1024\n"
      "All combinations of the values, or with --star one number at a time from the base. A combination that cannot be "
      "built is\n"
      "listed with its reason. Written: OUT/sweep.csv, sweep.json and plots; each point has a file in OUT/points, so "
      "that the\n"
      "same command goes on where it was cut off. --list, --point and --merge are for a workflow engine: "
      "cli/sweep/Snakefile.\n"
      "docs/trade.md tells what is measured.\n");
  command->add_option("SCENE", input.scenes, "built-in scenes, mesh files or screen-space *.tri")->required();
  add_scene_choice(command, input.shown);
  command
      ->add_option("--vary", input.vary,
                   "KEY=A,B,C or KEY=A..B: a number or a choice of the configuration, or keys, the frames made for "
                   "each key frame; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--config", input.choice.config, "the base: low, middle, high or a .toml file")
      ->capture_default_str();
  command->add_option("--lanes", input.choice.lanes, "pixels a stamp of the base: 1, 2, 4, 8, 16; default: its own");
  command->add_option("--size", input.size, "frame, WxH; default: the base's");
  command->add_option("--time", input.time, "seconds into the animations")->capture_default_str()->check(finite());
  command->add_option("--frames", input.frames, "of a base with motion: frames A:B of the animations, 30 a second")
      ->capture_default_str();
  command->add_flag("--star", input.choice.star,
                    "one number at a time from the base, in the place of all combinations");
  command->add_flag(
      "--named,!--no-named", input.choice.named,
      "low, middle and high as well, in the base's frame, range and lanes, where nothing is lit, textured or "
      "moves");
  command->add_option("--area", input.area, "targets for Yosys: xilinx,ecp5,ice40, or none")->capture_default_str();
  add_output_folder(command, "--out", input.out, "folder to write")->capture_default_str();
  command->add_option("--jobs", options->jobs, "points at a time")->capture_default_str()->check(CLI::Range(1, 256));
  auto* list = command->add_flag("--list", options->list, "print the points and stop");
  auto* point =
      command->add_option("--point", options->point, "compute this point of the list and stop")->check(above_zero());
  command->add_flag("--merge", options->merge, "tables and plots of points that are there")
      ->excludes(list)
      ->excludes(point);
  list->excludes(point);
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace halfspace::cli
