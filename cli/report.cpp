// SPDX-License-Identifier: Apache-2.0
// halfspace report: a scene three ways, as pictures and as the table of its stages.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/common/scene_input.hpp"
#include "cli/plots/picture.hpp"
#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

struct ReportOptions {
  SceneInput input;
  std::string out, cosim, rtl_frame, json;
  std::vector<std::string> units;
};

Json read_json(const std::string& path) {
  if (path.empty()) return Json::object();
  std::ifstream file(path);
  Json json = Json::parse(file, nullptr, false);
  if (!file || json.is_discarded() || !json.contains("runs")) {
    throw ref::Error(
        fmt::format("{}: not a report of the co-simulation: give what --json of a tb_ program wrote", path));
  }
  return json;
}

// The reports of several programs as one.
Json read_all(const std::vector<std::string>& paths) {
  Json all = {{"runs", Json::array()}, {"passed", true}};
  for (const std::string& path : paths) {
    const Json one = read_json(path);
    for (const Json& run : one["runs"]) all["runs"].push_back(run);
    if (!one.value("passed", true)) all["passed"] = false;
  }
  return all;
}

// The frame that the RTL drew, as raw RGBA.
ref::Frame read_rtl_frame(const std::string& path, const ref::Frame& like) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  const std::string text = bytes.str();
  ref::Frame frame = like;
  if (!file || text.size() != frame.colour.size() * 4) {
    throw ref::Error(
        fmt::format("{}: not a frame of {}x{} in RGBA: give what --dump of tb_pipeline wrote for this scene", path,
                    like.width, like.height));
  }
  std::memcpy(frame.colour.data(), text.data(), text.size());
  return frame;
}

struct Stage {
  std::string name;
  std::vector<std::string> streams;  // that it sends
};

// The units inside, in flow order.
std::vector<Stage> stages_of(const std::vector<model::Layout>& layouts) {
  std::vector<Stage> stages;
  for (const model::Layout& layout : layouts) {
    const std::string from = layout.row.from;
    if (from == "host" || from == "geometry") continue;
    const auto is_it = [&](const Stage& stage) { return stage.name == from; };
    auto found = std::find_if(stages.begin(), stages.end(), is_it);
    if (found == stages.end()) found = stages.insert(stages.end(), {from, {}});
    found->streams.push_back(layout.stream);
  }
  return stages;
}

// words and mismatches of a stage in the co-simulation.
std::pair<std::uint64_t, std::uint64_t> compared(const Json& cosim, const Stage& stage) {
  std::uint64_t words = 0, mismatches = 0;
  for (const Json& run : cosim.value("runs", Json::array())) {
    for (const Json& stream : run["streams"]) {
      const std::string name = stream["name"];
      if (std::find(stage.streams.begin(), stage.streams.end(), name) == stage.streams.end()) continue;
      words += stream["words"].get<std::uint64_t>();
      mismatches += stream["mismatches"].get<std::uint64_t>();
    }
  }
  return {words, mismatches};
}

std::string cycles_of(const Json& report, const std::string& unit) {
  for (const Json& run : report.value("runs", Json::array())) {
    if (run["unit"] == unit) return std::to_string(run["cycles"].get<std::uint64_t>());
  }
  return "–";
}

Json print_table(const Json& cosim, const Json& units, const model::Accuracy& a, const std::vector<Stage>& stages,
                 bool has_depth) {
  // Column widths count characters: fmt pads by display width.
  fmt::print("\n{:<15} {:>10} {:>10}  {:<34} {:>7} {:>10}\n", "stage", "words", "mismatches",
             "error against the reference", "dB", "cycles");
  Json rows = Json::array();
  for (const Stage& stage : stages) {
    const auto [words, mismatches] = compared(cosim, stage);
    std::string error = "–", ratio = "–";
    if (stage.name == "raster_pineda") error = fmt::format("{} pixels of coverage", a.covered_differ);
    if (stage.name.rfind("ztest", 0) == 0) {
      error = fmt::format("index {} pixels", a.index_differ);
      if (has_depth) {
        error = fmt::format("depth {} LSB, {}", a.depth_largest, error);
        ratio = decibels(a.depth_psnr);
      }
    }
    // The stage that sends the picture.
    if (&stage == &stages.back()) {
      error = fmt::format("colour {} LSB of 8", a.colour_largest);
      ratio = decibels(a.psnr);
    }
    fmt::print("{:<15} {:>10} {:>10}  {:<34} {:>7} {:>10}\n", stage.name, words, mismatches, error, ratio,
               cycles_of(units, stage.name));
    rows.push_back({{"stage", stage.name}, {"words", words}, {"mismatches", mismatches}, {"error", error}});
  }
  for (const Json& run : cosim.value("runs", Json::array())) {
    fmt::print("{:<15} {:>10} {:>10}  {:<34} {:>7} {:>10}\n", "pipeline", run["words"].get<std::uint64_t>(),
               run["mismatches"].get<std::uint64_t>(), "", "", run["cycles"].get<std::uint64_t>());
    fmt::print(
        "\nwords: RTL against kernels, to the bit. error: kernels against the floating-point reference, largest.\n"
        "cycles: of each unit alone without stalls; pipeline: {}.\n",
        run["cycles_of"].get<std::string>());
  }
  return rows;
}

int report(const ReportOptions& options) {
  const Json cosim = read_json(options.cosim), units = read_all(options.units);
  const LoadedScene loaded = load_snapped(options.input);
  if (loaded.between) {
    throw ref::Error(
        fmt::format("configuration {} gives motion and no picture: name one that shades", loaded.configuration.name()));
  }
  const ref::SnappedList& scene = loaded.list;
  const ref::Frame reference = reference_of(loaded);
  const auto engine = kernels_of(loaded, 16);
  const ref::Frame kernels = engine->render(scene);
  const model::Accuracy a = model::accuracy(reference, kernels, scene.format.depth_bits);
  tell_if_unseen(loaded, std::any_of(reference.index.begin(), reference.index.end(), [](auto n) { return n != 0; }));
  constexpr int kGain = 64;

  const std::filesystem::path out(options.out);
  model::make_folder(options.out);
  auto picture = [&](const char* name, const Picture& p) {
    write_picture((out / name).string(), p);
    fmt::print("{}\n", (out / name).string());
  };
  picture("frame_ref.png", colour_picture(reference));
  picture("frame_hls.png", colour_picture(kernels));
  bool rtl_equal = true;
  if (!options.rtl_frame.empty()) {
    const ref::Frame rtl = read_rtl_frame(options.rtl_frame, kernels);
    picture("frame_rtl.png", colour_picture(rtl));
    rtl_equal = rtl.colour == kernels.colour;
  }
  picture("index.png", index_picture(kernels));
  const bool has_depth = scene.format.depth_bits != 0;
  if (has_depth) picture("depth.png", depth_picture(kernels));
  picture(fmt::format("difference_x{}.png", kGain).c_str(),
          difference_picture(colour_picture(reference), colour_picture(kernels), kGain));

  const Json rows = print_table(cosim, units, a, stages_of(engine->layouts()), has_depth);
  write_json(options.json, {{"scene", options.input.scene},
                            {"config", scene.format.name},
                            {"accuracy", to_json(a)},
                            {"rows", rows},
                            {"rtl_frame_equals_kernels", rtl_equal}});
  bool passed = rtl_equal && a.covered_differ == 0;
  for (const Json* json : {&cosim, &units}) passed = passed && (*json).value("passed", true);
  if (!rtl_equal) std::fprintf(stderr, "halfspace: the frame of the RTL differs from the frame of the kernels\n");
  if (cosim.empty()) fmt::print("\nnothing of the RTL was compared: give --cosim\n");
  fmt::print("{}\n", passed ? "PASS" : "FAIL");
  return passed ? 0 : 1;
}

}  // namespace

void add_report(CLI::App& app, int& status) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command =
      app.add_subcommand("report", "pictures and the table of the stages, with the co-simulation's counts");
  command->footer(
      "  halfspace report teapot --config low --size 320x200 --out report    pictures of both, and errors by stage\n");
  add_scene_options(command, options->input);
  add_output_folder(command, "--out", options->out, "folder for the pictures")->required();
  command->add_option("--cosim", options->cosim, "JSON that tb_pipeline wrote");
  command->add_option("--units", options->units, "JSON that the benches of units wrote, a file each");
  command->add_option("--rtl-frame", options->rtl_frame, "RGBA frame that tb_pipeline wrote");
  add_json(command, options->json);
  command->callback([options, &status] { status = report(*options); });
}

}  // namespace halfspace::cli
