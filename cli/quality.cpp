// SPDX-License-Identifier: Apache-2.0
// halfspace quality
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/sequence_quality.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

struct Options {
  SequenceOptions sequence;
  std::string plot, json;
};

void print(const char* method, const ref::Quality& q) {
  fmt::print("{:<20} {:>9.2f} {:>8.4f}", method, q.psnr_y, q.ssim);
  for (const double share : q.blocks) fmt::print(" {:>9.2f}%", 100 * share);
  fmt::print("\n");
}

void quality(const Options& options) {
  const SequenceQuality q = measure_sequence(options.sequence, true);
  if (q.between == 0) throw ref::Error(fmt::format("{}: no frame lies between keys: lower --psnr", options.sequence.scene));
  fmt::print("{} {} {}x{}: {} frames, {} keys, {} in between, against these as rendered\n\n{:<20} {:>9} {:>8}",
             options.sequence.engine, options.sequence.scene, q.sequence.width, q.sequence.height, q.sequence.frames,
             q.sequence.keys.size(), q.between, "", "PSNR_Y dB", "SSIM");
  for (int n = 0; n < ref::kBlockClasses; ++n) fmt::print(" {:>10}", ref::name_of(ref::BlockClass(n)));
  fmt::print("\n");
  print("motion compensated", q.compensated);
  print("temporal average", q.average);
  print("nearer key", q.repeat);
  if (q.minterpolate) print("ffmpeg minterpolate", *q.minterpolate);
  else fmt::print("{:<20} not measured: it takes ffmpeg, and three keys or more as far apart as each other\n", "ffmpeg minterpolate");
  const double shown = double(q.shares.blended + q.shares.copied + q.shares.filled);
  fmt::print("\nof covered pixels {:.2f} % blended, {:.2f} % copied from one key, {:.2f} % rendered; classes are of 4x4 blocks, from {} dB on\n",
             100 * double(q.shares.blended) / shown, 100 * double(q.shares.copied) / shown, 100 * double(q.shares.filled) / shown,
             fmt::join(ref::kBlockBorders, ", "));
  Json json = {{"scene", options.sequence.scene}, {"engine", options.sequence.engine}};
  json.update(to_json(q));
  write_json(options.json, json);
  if (!options.plot.empty()) plot_blocks(q, options.sequence.scene, options.plot);
}

}  // namespace

void add_quality(CLI::App& app, int&) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("quality", "how near frames between key frames are to these as rendered");
  add_sequence_options(command, options->sequence);
  command->add_option("--plot", options->plot, "picture of the classes of blocks, a frame a bar");
  command->add_option("--json", options->json, "file for the numbers");
  command->footer("  halfspace quality cube_fast                                         the kernels\n"
                  "  halfspace quality cube_fast --engine ref --method straight --filter area --no-index-test   as the paper has it\n"
                  "PSNR_Y is 0.299 PSNR_R + 0.587 PSNR_G + 0.114 PSNR_B, 99 dB at most a channel.\n");
  command->callback([options] { quality(*options); });
}

}  // namespace halfspace::cli
