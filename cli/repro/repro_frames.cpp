// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/plots/sequence_quality.hpp"
#include "cli/plots/video.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

// The paper's animations, dB; ours stand for them.
struct Printed {
  const char* animation;
  double average, compensated;
  const char* scene;
};
constexpr Printed kPrinted[] = {{"TieFighter", 22.96, 36.17, "drone"},
                                {"F14 Tomcat", 23.13, 34.54, "jet"},
                                {"Cube, fast zoom in and out", 20.12, 33.53, "cube_zoom"},
                                {"Cube, fast rotation", 16.92, 29.97, "cube_fast"},
                                {"Cube, slow rotation", 22.75, 31.05, "cube_slow"},
                                {"Pyramid, fast rotation", 15.77, 33.56, "pyramid_fast"},
                                {"Pyramid, slow rotation", 22.57, 31.54, "pyramid_slow"},
                                {"Wheel, in-out motion", 30.25, 39.91, "wheel_in_out"},
                                {"Wheel, rotation", 23.35, 34.05, "wheel_turn"},
                                {"Falling ring", 19.33, 26.64, "ring_fall"}};

struct Kind {
  const char* name;
  const char* title;
  const char* texture;
  int samples;
};
constexpr Kind kKinds[] = {{"gouraud", "Gouraud", "none", 1},
                           {"textured", "textured", "bilinear", 1},
                           {"supersampled", "Gouraud, 4x4 samples a pixel", "none", 4},
                           {"supersampled_textured", "textured, 4x4 samples a pixel", "bilinear", 4}};

struct ReproFramesOptions {
  std::vector<std::string> kinds;
  std::string size = "320x240", out, json;
  int frames = 0;
};

SequenceOptions sequence_of(const ReproFramesOptions& options, const Printed& row, const Kind& kind) {
  SequenceOptions sequence;
  sequence.scene = row.scene;
  sequence.size = options.size;
  sequence.frames = options.frames;
  sequence.texture = kind.texture;
  sequence.samples = kind.samples;
  return sequence;
}

// The paper's own method: straight lines, weights by area, no test of what a place shows.
SequenceOptions as_printed(SequenceOptions sequence) {
  sequence.engine = "ref";
  sequence.method = "straight";
  sequence.filter = "area";
  sequence.index_test = false;
  return sequence;
}

Json measure_kind(const ReproFramesOptions& options, const Kind& kind) {
  fmt::print(
      "{}, {}, one frame in five drawn; PSNR_Y in dB of the frames in between, mean\n\n"
      "{:<27} {:>8} {:>8}   {:<13} {:>8} {:>9} {:>12} {:>8} {:>8} {:>10}\n",
      kind.title, options.size, "the paper's", "average", "compens.", "ours", "average", "as paper", "minterpolate",
      "ref", "kernels", "< 20 dB");
  Json rows = Json::array();
  std::array<double, 7> sum{};
  bool all_interpolated = true;
  for (const Printed& row : kPrinted) {
    SequenceOptions sequence = sequence_of(options, row, kind);
    const SequenceQuality kernels = measure_sequence(sequence, true);
    const SequenceQuality printed = measure_sequence(as_printed(sequence), false);
    sequence.engine = "ref";
    const SequenceQuality reference = measure_sequence(sequence, false);
    const double interpolated = kernels.minterpolate ? kernels.minterpolate->psnr_y : 0;
    all_interpolated = all_interpolated && kernels.minterpolate;
    const std::array<double, 7> numbers = {row.average,
                                           row.compensated,
                                           kernels.average.psnr_y,
                                           printed.compensated.psnr_y,
                                           interpolated,
                                           reference.compensated.psnr_y,
                                           kernels.compensated.psnr_y};
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += numbers[n] / double(std::size(kPrinted));
    fmt::print("{:<27} {:>8.2f} {:>8.2f}   {:<13} {:>8.2f} {:>9.2f} {:>12} {:>8.2f} {:>8.2f} {:>9.3f}%\n",
               row.animation, numbers[0], numbers[1], row.scene, numbers[2], numbers[3],
               kernels.minterpolate ? fmt::format("{:.2f}", interpolated) : "-", numbers[5], numbers[6],
               100 * kernels.compensated.blocks[0]);
    Json json = {{"animation", row.animation},
                 {"scene", row.scene},
                 {"kind", kind.name},
                 {"printed", {{"average_db", row.average}, {"compensated_db", row.compensated}}}};
    json["kernels"] = to_json(kernels);
    json["reference"] = to_json(reference);
    json["as_printed"] = to_json(printed);
    rows.push_back(std::move(json));
    if (!options.out.empty()) {
      const std::string picture =
          (std::filesystem::path(options.out) / fmt::format("blocks_{}_{}.png", kind.name, row.scene)).string();
      plot_blocks(kernels, fmt::format("{}, {}", row.scene, kind.title), picture);
    }
  }
  fmt::print("{:<27} {:>8.2f} {:>8.2f}   {:<13} {:>8.2f} {:>9.2f} {:>12} {:>8.2f} {:>8.2f}\n\n", "mean", sum[0], sum[1],
             "", sum[2], sum[3], all_interpolated ? fmt::format("{:.2f}", sum[4]) : "-", sum[5], sum[6]);
  return rows;
}

void repro_c(const ReproFramesOptions& options) {
  Json json = {{"paper", "frame-rate up-conversion"}, {"rows", Json::array()}};
  if (!options.out.empty()) model::make_folder(options.out);
  for (const Kind& kind : kKinds) {
    const bool wanted = options.kinds.empty() ||
                        std::find(options.kinds.begin(), options.kinds.end(), kind.name) != options.kinds.end();
    if (!wanted) continue;
    for (Json& row : measure_kind(options, kind)) json["rows"].push_back(std::move(row));
  }
  write_json(options.json, json);
}

}  // namespace

void add_repro_frames(CLI::App* repro) {
  auto options = std::make_shared<ReproFramesOptions>();
  CLI::App* paper = repro->add_subcommand("C", "frame-rate up-conversion");
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  paper->add_option("KIND", options->kinds, "gouraud, textured, supersampled, supersampled_textured; default: all four")
      ->check(CLI::IsMember(names));
  paper->add_option("--size", options->size, "frame, WxH")->capture_default_str();
  paper->add_option("--frames", options->frames, "of each animation; default: all")->check(above_zero());
  add_output_folder(paper, "--out", options->out, "folder for the plots of blocks");
  add_json(paper, options->json);
  paper->callback([options] { repro_c(*options); });
}

}  // namespace halfspace::cli
