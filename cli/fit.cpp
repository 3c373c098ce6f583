// SPDX-License-Identifier: Apache-2.0
// halfspace fit
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/common/area.hpp"
#include "cli/common/cosim.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_frames.hpp"
#include "cli/plots/picture.hpp"
#include "model/formats/format_fields.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "study/fit/fit.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

using model::Configuration;
using model::Fit;
using model::FitScene;

struct FitOptions {
  FrameInput input;
  model::FitGoal goal;
  int lanes = 0;
  std::string output, work, json, area = "xilinx";
  bool cosim = true;
};

std::string name_of(const std::string& scene) {
  std::string name = std::filesystem::path(scene).stem().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
}

Json json_of(const model::Requirements& r) {
  return {{"x", {r.x_low, r.x_high}},
          {"y", {r.y_low, r.y_high}},
          {"triangles", r.triangles},
          {"depth_gradient_of_full_scale_a_pixel", r.depth_gradient},
          {"colour_gradient_lsb_a_pixel", r.colour_gradient},
          {"depth_separation_of_full_scale", r.overlapping ? Json(r.depth_separation) : Json(nullptr)},
          {"overlapping_pixels", r.overlapping},
          {"one_colour_each", r.one_colour_each},
          {"motion_pixels_a_frame", r.motion}};
}

void print(const model::Requirements& r, const FitScene& scene) {
  fmt::print("{}: {} frame{} of {}x{}{}\n", scene.name, scene.frames.size(), scene.frames.size() == 1 ? "" : "s",
             scene.width, scene.height, scene.views > 1 ? fmt::format(", from {} sides", scene.views) : "");
  fmt::print("  vertices within x {:.0f} … {:.0f}, y {:.0f} … {:.0f} pixels; {} triangles in view at most\n", r.x_low,
             r.x_high, r.y_low, r.y_high, r.triangles);
  fmt::print("  steepest plane: depth {:.3g} of full scale a pixel, colour {:.3g} LSB a pixel; {}\n", r.depth_gradient,
             r.colour_gradient, r.one_colour_each ? "each triangle has one colour" : "colours vary over triangles");
  if (r.overlapping == 0) fmt::print("  no pixel has two surfaces\n");
  else
    fmt::print("  {} pixels have two surfaces or more, as near as {:.2g} of full scale\n", r.overlapping,
               r.depth_separation);
  if (scene.frames.size() > scene.views) fmt::print("  a vertex moves {:.2f} pixels a frame at most\n", r.motion);
}

// What is not there, and why.
std::vector<std::string> left_out(const Config& c, const model::Requirements& r) {
  std::vector<std::string> lines;
  if (!has_depth(c)) {
    lines.push_back(
        fmt::format("Z-buffer, depth plane and comparison: {}",
                    r.overlapping == 0 ? "no pixel has two surfaces" : "what is drawn first is never behind"));
  }
  if (!is_gouraud(c)) {
    lines.push_back(
        fmt::format("colour planes and the shader's multipliers: {}",
                    r.one_colour_each ? "each triangle has one colour" : "one colour each is as accurate as asked"));
  }
  if (!has_planes(c)) lines.push_back("reciprocal of the area: no triangle has a plane");
  return lines;
}

Json json_of(const model::FitObjects& o) {
  if (o.why.empty()) return nullptr;
  return {{"objects", o.objects},
          {"moving", o.moving},
          {"standing", o.standing},
          {"cycles_all", o.cycles_all},
          {"cycles_moving", o.cycles_moving},
          {"why", o.why}};
}

Json json_of(const model::FitArchitecture& a) {
  if (a.why.empty()) return nullptr;
  return {{"z_buffer_bits", a.z_buffer_bits},
          {"tdbv_bits", a.tdbv_bits},
          {"cycles_delta", a.cycles_delta},
          {"cycles_gamma", a.cycles_gamma},
          {"why", a.why}};
}

void print_numbers(const Fit& fit, const Configuration& high) {
  const Config c = fit.configuration.config(), h = high.config();
  fmt::print("\n{:<18} {:>9} {:>9}\n", "", fit.configuration.name(), high.name());
  for (const auto& field : model::numbers_of(Part::kBase))
    fmt::print("{:<18} {:>9} {:>9}\n", field.name, field.get(c), field.get(h));
  if (has_objects(c)) fmt::print("{:<18} {:>9} {:>9}\n", "object_bits", c.object_bits, h.object_bits);
  fmt::print("\none bit less:\n");
  for (const auto& less : fit.less) fmt::print("  {:<26} {}\n", less.change, less.result);
  const auto mine = model::memory_bits(c), theirs = model::memory_bits(h);
  fmt::print(
      "\nframe memories: {:.2f} Mbit (I-buffer {:.2f}, Z-buffer {:.2f}, TdbS {:.2f}, TdbV {:.2f}, objects {:.2f}), {} "
      "has {:.2f} Mbit: {:.1f} % saved\n",
      mine.total() / 1e6, mine.index / 1e6, mine.depth / 1e6, mine.shading / 1e6, mine.visibility / 1e6,
      mine.object / 1e6, high.name(), theirs.total() / 1e6, 100 - 100.0 * mine.total() / theirs.total());
}

// The pipeline of both, with the same lanes, and what is saved, for each target.
Json compare_area(const Fit& fit, const Configuration& high, const std::vector<std::string>& targets,
                  const std::string& work) {
  if (targets.empty()) return nullptr;
  const int lanes = fit.configuration.config().lanes;
  Config beside = high.config();
  beside.lanes = lanes;
  const auto measured = [&](const Configuration& configuration) {
    const Waiting waiting(fmt::format("area of {} with {} lane{} by Yosys, some minutes", configuration.name(), lanes,
                                      lanes == 1 ? "" : "s"));
    return measure_area(configuration, targets, work + "/area");
  };
  const Json mine = measured(fit.configuration), theirs = measured(Configuration(high.name(), beside));
  Json json = Json::object();
  for (const std::string& target : targets) {
    const auto pipeline = [&](const Json& area) {
      for (const Json& row : area["rows"]) {
        if (row["unit"] == "pipeline" && row["target"] == target) return row;
      }
      throw ref::Error("the area tool tells nothing of the pipeline: this is a fault of the program");
    };
    const Json a = pipeline(mine), b = pipeline(theirs);
    fmt::print("{}, {} lane{}, beside {} with as many:", target, lanes, lanes == 1 ? "" : "s", high.name());
    for (const char* column : {"lut", "ff", "dsp", "memory_bits"}) {
      const double here = a[column].get<double>(), there = b[column].get<double>();
      fmt::print(" {} of {} {}{}", a[column].get<std::uint64_t>(), b[column].get<std::uint64_t>(), column,
                 there > 0 ? fmt::format(" ({:.0f} % saved);", 100 - 100 * here / there) : ";");
      json[target][column] = {{"fit", a[column]}, {high.name(), b[column]}};
    }
    fmt::print("\n");
  }
  return json;
}

// Renders the frames anew and runs the RTL on them. Throws when either fails.
Json prove(const FitOptions& options, const FitScene& scene, const Fit& fit, const std::string& work) {
  const int lanes = fit.configuration.config().lanes;
  const auto again = model::check_fit(scene, fit.configuration, options.goal, lanes == 1 ? 4 : 1);
  fmt::print("rendered again with {} lanes: {:.2f} dB, a colour off by {:.2f} LSB at most, {} pixels of another face\n",
             lanes == 1 ? 4 : 1, again.psnr, again.largest_lsb, again.wrong_pixels);
  if (!again.holds)
    throw ref::Error(fmt::format("{}: the configuration does not hold when rendered again: {}", scene.name, again.why));
  Json json = {{"psnr_db", again.psnr}, {"largest_lsb", again.largest_lsb}, {"wrong_pixels", again.wrong_pixels}};
  if (!options.cosim) return json;

  std::vector<model::NamedFrame> frames;
  const ref::RasterFormat format = model::raster_format(fit.configuration);
  for (std::size_t k = 0; k < scene.frames.size(); ++k) {
    const auto list = scene.frames[k]({scene.width, scene.height, format.range_bits, format.subpixel_bits});
    frames.push_back(
        {fmt::format("{} at {} s, side {}", scene.name, scene.times[k], scene.side(k)), ref::snap(list, format)});
  }
  const Cosimulation cosim = cosimulate(work, scene.name, fit.configuration, lanes, frames);
  fmt::print("co-simulated: {} words, {} mismatches, {} cycles a frame with {} lane{}\n", cosim.words, cosim.mismatches,
             cosim.cycles, lanes, lanes == 1 ? "" : "s");
  if (cosim.mismatches)
    throw ref::Error(fmt::format("{}: the RTL differs from the kernels: read {}/cosim.log", scene.name, work));
  json["cosim"] = {
      {"words", cosim.words}, {"mismatches", cosim.mismatches}, {"cycles", cosim.cycles}, {"lanes", lanes}};
  return json;
}

void fit(const FitOptions& options) {
  const std::vector<std::string> targets = area_targets(options.area);
  std::optional<model::StagedFile> output;  // before the work: whether it can be written
  if (!options.output.empty()) output.emplace(options.output);
  const FitScene scene = load_frames(options.input);
  const model::Requirements needed = model::requirements(scene);
  if (needed.triangles == 0) {
    throw ref::Error(
        fmt::format("{}: nothing of it is in the frames that are looked at: choose others by --frames, or "
                    "another camera",
                    scene.name));
  }
  print(needed, scene);
  const std::string name = options.output.empty() ? name_of(scene.name) : name_of(options.output);
  Progress progress("fit " + scene.name + ": configurations tried");
  const Fit found = model::fit_configuration(scene, name, options.goal, options.lanes,
                                             [&](std::uint64_t tried) { progress.tell(tried, tried); });
  fmt::print("\n{} configurations tried: {:.2f} dB, a colour off by {:.2f} LSB at most\n", found.tried,
             found.outcome.psnr, found.outcome.largest_lsb);
  const std::vector<std::string> gone = left_out(found.configuration.config(), needed);
  fmt::print("left out: {}\n", gone.empty() ? "nothing, every unit is needed" : "");
  for (const std::string& line : gone) fmt::print("  {}\n", line);
  const Configuration high = model::find_configuration("high");
  if (!found.architecture.why.empty()) {
    fmt::print("type {}: {}\n", model::find_field("architecture")->text(found.configuration.config()),
               found.architecture.why);
  }
  if (!found.objects.why.empty()) {
    fmt::print("static objects buffers: {}: {}\n", has_objects(found.configuration.config()) ? "yes" : "no",
               found.objects.why);
  }
  print_numbers(found, high);
  const std::string work = options.work.empty() ? "fit_" + name : options.work;
  model::make_folder(work);
  const Json area = compare_area(found, high, targets, work);
  const Json proof = prove(options, scene, found, work);
  if (output) output->write(model::configuration_toml(found.configuration)), output->commit();

  Json less = Json::array();
  for (const auto& one : found.less) less.push_back({{"change", one.change}, {"result", one.result}});
  write_json(
      options.json,
      {{"scene", scene.name},
       {"frames", scene.frames.size()},
       {"views", scene.views},
       {"width", scene.width},
       {"height", scene.height},
       {"goal", {{"psnr_db", options.goal.psnr}, {"max_lsb", options.goal.max_lsb}, {"cycles", options.goal.cycles}}},
       {"requires", json_of(needed)},
       {"tried", found.tried},
       {"configuration", to_json(found.configuration.config())},
       {"left_out", gone},
       {"architecture", json_of(found.architecture)},
       {"static_objects", json_of(found.objects)},
       {"one_bit_less", less},
       {"memory_bits", to_json(model::memory_bits(found.configuration.config()))},
       {"memory_bits_of_high", to_json(model::memory_bits(high.config()))},
       {"area", area},
       {"proof", proof}});
}

}  // namespace

void add_fit(CLI::App& app, int&) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command =
      app.add_subcommand("fit", "find the cheapest configuration that draws a scene as accurately as asked");
  command->footer(
      "All frames of the scene are drawn with configurations of ever fewer bits, against the ideal picture: positions "
      "not\n"
      "snapped, nothing rounded. What is found is rendered again, and its RTL co-simulated, before it is written.\n"
      "  halfspace fit cube --size 160x120 --psnr 45 --area none -o cube.toml\n"
      "  halfspace fit teapot --views 4 --size 320x240 --area none --no-cosim  from four sides\n"
      "  halfspace fit drone --frames 0:4 --size 160x120 --max-lsb 2 --area none -o drone.toml\n"
      "Without --area none, its circuit beside that of high, by Yosys: minutes.\n");
  add_frame_options(command, options->input);
  command
      ->add_option("--views", options->input.views,
                   "the scene from so many sides, its view turned about the vertical; the worst counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 360));
  command->add_option("--psnr", options->goal.psnr, "dB against the ideal picture, of each frame; 0: not asked")
      ->capture_default_str()
      ->check(zero_or_more());
  command
      ->add_option("--max-lsb", options->goal.max_lsb,
                   "largest error of a colour, LSB of 8 bits, where the face is right; 0: not asked")
      ->capture_default_str()
      ->check(zero_or_more());
  command
      ->add_option("--cycles", options->goal.cycles,
                   "cycles a frame at most: takes as many lanes as that needs; 0: not asked")
      ->capture_default_str()
      ->check(zero_or_more());
  command->add_flag("--static-objects", options->goal.static_objects,
                    "let pixels know their objects, for static objects buffers, where some move, some stand still, and "
                    "it saves cycles");
  command->add_option("--lanes", options->lanes, "pixels a cycle; default: the fewest");
  add_output_file(command, "-o,--output", options->output, "configuration to write");
  add_output_folder(command, "--work", options->work, "folder for the bench and the vectors; default: fit_NAME");
  command->add_flag("--cosim,!--no-cosim", options->cosim, "co-simulate the RTL of what is found");
  command->add_option("--area", options->area, "targets for Yosys: xilinx,ecp5,ice40, all, or none")
      ->capture_default_str();
  add_json(command, options->json);
  command->callback([options] { fit(*options); });
}

}  // namespace halfspace::cli
