// SPDX-License-Identifier: Apache-2.0
// halfspace fit
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>

#include "cli/commands.hpp"
#include "cli/common/area.hpp"
#include "cli/common/cosim.hpp"
#include "cli/common/fit_between.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_frames.hpp"
#include "cli/parts/fit_part.hpp"
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
  std::string output, work, json, area = "xilinx", cost = "memory", shading = "gouraud";
  std::string filter = "bilinear", part;
  int keys = 0;
  bool lit = false;
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
  if (!shades_planes(c)) {
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

// Does the circuit light, or draw textures? *high* does neither, and its numbers are no measure then.
bool is_rich(const Config& c) { return has_lighting(c) || has_texture(c); }

void print_numbers(const Fit& fit, const Configuration& high) {
  const Config c = fit.configuration.config(), h = high.config();
  const bool beside = !is_rich(c);
  fmt::print("\n{:<20} {:>11}{}\n", "", fit.configuration.name(), beside ? fmt::format(" {:>9}", high.name()) : "");
  for (const model::ConfigField& field : model::config_fields()) {
    if (!has_part(field.part, c) || (field.part == Part::kBase && !field.is_number() && !is_rich(c))) continue;
    fmt::print("{:<20} {:>11}{}\n", field.name, field.text(c), beside ? fmt::format(" {:>9}", field.text(h)) : "");
  }
  fmt::print("\na step less:\n");
  for (const auto& less : fit.less) fmt::print("  {:<26} {}\n", less.change, less.result);
  const auto mine = model::memory_bits(c), theirs = model::memory_bits(h);
  if (!beside) {
    const model::TextureBits texture = model::texture_bits(c);
    fmt::print(
        "\nframe memories: {:.2f} Mbit (I-buffer {:.2f}, Z-buffer {:.2f}, TdbS {:.2f}, TdbV {:.2f}), planes of texture "
        "{:.2f}, texels {:.2f}\n",
        mine.total() / 1e6, mine.index / 1e6, mine.depth / 1e6, mine.shading / 1e6, mine.visibility / 1e6,
        texture.planes / 1e6, texture.texels / 1e6);
    return;
  }
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
  const bool alone = is_rich(fit.configuration.config());
  Config beside = high.config();
  beside.lanes = lanes;
  const auto measured = [&](const Configuration& configuration) {
    const Waiting waiting(fmt::format("area of {} with {} lane{} by Yosys, some minutes", configuration.name(), lanes,
                                      lanes == 1 ? "" : "s"));
    return measure_area(configuration, targets, work + "/area");
  };
  const Json mine = measured(fit.configuration);
  const Json theirs = alone ? mine : measured(Configuration(high.name(), beside));
  Json json = Json::object();
  for (const std::string& target : targets) {
    const auto pipeline = [&](const Json& area) {
      for (const Json& row : area["rows"]) {
        if (row["unit"] == "pipeline" && row["target"] == target) return row;
      }
      throw ref::Error("the area tool tells nothing of the pipeline: this is a fault of the program");
    };
    const Json a = pipeline(mine), b = pipeline(theirs);
    if (alone) {
      fmt::print("{}, {} lane{}: {} LUT, {} FF, {} DSP, {} bits of memories\n", target, lanes, lanes == 1 ? "" : "s",
                 a["lut"].get<std::uint64_t>(), a["ff"].get<std::uint64_t>(), a["dsp"].get<std::uint64_t>(),
                 a["memory_bits"].get<std::uint64_t>());
      for (const char* column : {"lut", "ff", "dsp", "memory_bits"}) json[target][column] = {{"fit", a[column]}};
      continue;
    }
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
  for (std::size_t k = 0; k < scene.frames.size(); ++k) {
    model::NamedFrame frame = scene.frames[k].drawn(fit.configuration.config(), scene.width, scene.height).frame;
    frame.note = fmt::format("{} at {} s, side {}", scene.name, scene.times[k], scene.side(k));
    frames.push_back(std::move(frame));
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

// LUTs or DSPs of the pipeline for the first target, where they are to be least.
std::function<double(const Configuration&)> synthesis(const FitOptions& options,
                                                      const std::vector<std::string>& targets,
                                                      const std::string& work) {
  if (targets.empty() || (options.goal.cost != model::FitCost::kLut && options.goal.cost != model::FitCost::kDsp))
    return nullptr;
  const char* column = options.goal.cost == model::FitCost::kLut ? "lut" : "dsp";
  return [=](const Configuration& configuration) {
    const Waiting waiting("area of what was found, by Yosys, some minutes");
    for (const Json& row : measure_area(configuration, {targets.front()}, work + "/area")["rows"]) {
      if (row["unit"] == "pipeline") return row[column].get<double>();
    }
    throw ref::Error("the area tool tells nothing of the pipeline: this is a fault of the program");
  };
}

void fit(FitOptions options) {
  options.goal.cost = model::FitCost(std::find(std::begin(model::kFitCosts), std::end(model::kFitCosts), options.cost) -
                                     std::begin(model::kFitCosts));
  if (options.keys != 0) {
    return fit_between({options.input, options.goal, options.keys, options.filter, options.cost, options.output,
                        options.work, options.json, options.cosim});
  }
  const Fpga* part = options.part.empty() ? nullptr : &find_part(options.part);
  if (part && options.lanes == 0) options.lanes = 1;
  const std::vector<std::string> targets = area_targets(part ? "none" : options.area);
  std::optional<model::StagedFile> output;  // before the work: whether it can be written
  if (!options.output.empty()) output.emplace(options.output);
  const FitScene scene = load_frames(options.input);
  const model::Requirements needed = model::requirements(scene);
  if (needed.triangles == 0) {
    throw ref::Error(fmt::format(
        "{}: nothing of it is in the frames that are looked at: choose others by --frames, or another camera",
        scene.name));
  }
  print(needed, scene);
  model::FitGoal& goal = options.goal;
  goal.look.texture = texture_of(options.input, scene);
  goal.look.shading = options.shading == "phong" ? ref::ShadingMode::kPhong : ref::ShadingMode::kGouraud;
  goal.look.distant = options.lit || options.shading == "phong";
  if (goal.look.distant && !scene.frames.front().scene())
    throw ref::Error(
        fmt::format("{}: its triangles have colours and no normals: leave out --lit and --shading phong", scene.name));
  fmt::print("  the ideal picture: {}; what is to be least: {}\n", ref::name_of(goal.look), options.cost);
  const std::string name = name_of(options.output.empty() ? scene.name : options.output);
  const std::string work = options.work.empty() ? "fit_" + name : options.work;
  model::make_folder(work);
  goal.measured = synthesis(options, targets, work);
  Progress progress("fit " + scene.name + ": configurations tried");
  const auto search = [&](const model::FitGoal& aim) {
    return model::fit_configuration(scene, name, aim, options.lanes,
                                    [&](std::uint64_t tried) { progress.tell(tried, tried); });
  };
  const bool circuit = options.area != "none";
  const Fit found = part ? fit_in_part(*part, options.input.scene, goal, circuit, work, search) : search(goal);
  goal.psnr = std::min(goal.psnr, found.outcome.psnr);  // of a part that holds less
  fmt::print(
      "\n{} configurations tried, {} from which nothing can be taken: {:.2f} dB, a colour off by {:.2f} LSB at "
      "most, {} pixels of another face\n",
      found.tried, found.ends, found.outcome.psnr, found.outcome.largest_lsb, found.outcome.wrong_pixels);
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
  const Json area = compare_area(found, high, targets, work);
  const Json proof = prove(options, scene, found, work);
  if (output) output->write(model::configuration_toml(found.configuration)), output->commit();

  Json less = Json::array();
  for (const auto& one : found.less) less.push_back({{"change", one.change}, {"result", one.result}});
  write_json(options.json, {{"scene", scene.name},
                            {"frames", scene.frames.size()},
                            {"views", scene.views},
                            {"width", scene.width},
                            {"height", scene.height},
                            {"goal",
                             {{"psnr_db", goal.psnr},
                              {"max_lsb", goal.max_lsb},
                              {"wrong_pixels", goal.wrong_pixels < 0 ? Json(nullptr) : Json(goal.wrong_pixels)},
                              {"cycles", goal.cycles},
                              {"cost", options.cost},
                              {"ideal", ref::name_of(goal.look)}}},
                            {"requires", json_of(needed)},
                            {"tried", found.tried},
                            {"ends", found.ends},
                            {"cost", found.cost},
                            {"configuration", to_json(found.configuration.config())},
                            {"left_out", gone},
                            {"architecture", json_of(found.architecture)},
                            {"static_objects", json_of(found.objects)},
                            {"one_bit_less", less},
                            {"memory_bits", to_json(model::memory_bits(found.configuration.config()))},
                            {"texture_bits",
                             {{"planes", model::texture_bits(found.configuration.config()).planes},
                              {"texels", model::texture_bits(found.configuration.config()).texels}}},
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
      "snapped, nothing rounded, texels of the file. Numbers, units and choices are all tried. What is found is "
      "rendered again, and its RTL co-simulated, before it is written.\n"
      "  halfspace fit cube --size 160x120 --psnr 45 --area none -o cube.toml\n"
      "  halfspace fit teapot --views 4 --size 320x240 --area none --no-cosim  from four sides\n"
      "  halfspace fit drone --frames 0:4 --size 160x120 --max-lsb 2 --area none -o drone.toml\n"
      "  halfspace fit cube_fast --frames 0:2 --size 160x120 --texture bilinear --psnr 35 --area none -o brick.toml\n"
      "  halfspace fit teapot --size 160x120 --shading phong --psnr 38 --area none -o phong.toml  lit by the hardware\n"
      "  halfspace fit drone --keys 1 --frames 0:4 --size 96x72 --psnr 50 --no-cosim -o motion.toml  frames in "
      "between\n"
      "  halfspace fit cube --size 160x120 --psnr 30 --part up5k -o part.toml  what a small FPGA holds\n"
      "Without --area none, its circuit beside that of high, or in the --part, by Yosys: minutes.\n");
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
      ->add_option("--wrong-pixels", options->goal.wrong_pixels,
                   "of each frame, that show another face than the ideal picture, at most; default: not asked")
      ->check(zero_or_more());
  command
      ->add_option("--cost", options->cost,
                   "what is to be least: memory (bits), lut, dsp (by Yosys with --area, else by the bits of numbers), "
                   "cycles, bytes (of the frame that takes most)")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(model::kFitCosts), std::end(model::kFitCosts))))
      ->capture_default_str();
  command->add_option("--shading", options->shading, "of the ideal picture: gouraud, phong, which the hardware lights")
      ->check(CLI::IsMember({"gouraud", "phong"}))
      ->capture_default_str();
  command
      ->add_option("--keys", options->keys,
                   "of an animation: frames made for each key frame, 1 to 4, held against the reference's; gives a "
                   "configuration of motion")
      ->check(CLI::Range(1, 4));
  command->add_option("--filter", options->filter, "of key frames, with --keys")
      ->check(CLI::IsMember({"nearest", "bilinear", "area", "bicubic"}))
      ->capture_default_str();
  command->add_flag("--lit", options->lit, "the hardware lights; else triangles come lit");
  command
      ->add_option("--cycles", options->goal.cycles,
                   "cycles a frame at most: takes as many lanes as that needs; 0: not asked")
      ->capture_default_str()
      ->check(zero_or_more());
  command->add_flag("--static-objects", options->goal.static_objects,
                    "let pixels know their objects, for static objects buffers, where some move, some stand still, and "
                    "it saves cycles");
  command->add_option("--lanes", options->lanes, "pixels a cycle; default: the fewest");
  command->add_option("--part", options->part,
                      "an FPGA of `halfspace config --parts`, that has to hold it; asks for fewer dB until it does");
  add_output_file(command, "-o,--output", options->output, "configuration to write");
  add_output_folder(command, "--work", options->work, "folder for the bench and the vectors; default: fit_NAME");
  command->add_flag("--cosim,!--no-cosim", options->cosim, "co-simulate the RTL of what is found");
  command->add_option("--area", options->area, "targets for Yosys: xilinx,ecp5,ice40, all, or none")
      ->capture_default_str();
  add_json(command, options->json);
  command->callback([options] { fit(*options); });
}

}  // namespace halfspace::cli
