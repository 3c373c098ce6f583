// SPDX-License-Identifier: Apache-2.0
// halfspace quality
#include <fmt/format.h>

#include <charconv>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/plots/gnuplot.hpp"
#include "cli/plots/sequence_quality.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

struct QualityOptions {
  SequenceOptions sequence;
  std::string plot, json, vary;
};

// `rendered`: the share of the covered pixels that have a sample that no key shows.
void print(const char* method, const ref::Quality& q, std::optional<double> rendered = {}) {
  fmt::print("{:<20} {:>9.2f} {:>9} {:>8.4f}", method, q.psnr_y,
             rendered ? fmt::format("{:.2f}%", 100 * *rendered) : "", q.ssim);
  for (const double share : q.blocks) fmt::print(" {:>9.2f}%", 100 * share);
  fmt::print("\n");
}

// Sums over the frames in between.
void print_work(const SequenceQuality& with, const SequenceQuality& without) {
  fmt::print("\n{:<20} {:>11} {:>14} {:>12} {:>12} {:>12} {:>14}\n", "", "triangles", "of S-buffer", "words",
             "key tiles", "key bytes", "compensation");
  for (const SequenceQuality* q : {&with, &without}) {
    const Work& w = q->work;
    fmt::print("{:<20} {:>11} {:>14} {:>12} {:>12} {:>12} {:>7} cycles\n", q == &with ? "with S-buffer" : "without",
               w.triangles, w.static_triangles, w.words, w.tiles, w.tiles * std::size_t(q->sequence.tile_bytes),
               w.cycles);
  }
}

void quality(const QualityOptions& options) {
  const SequenceQuality q = measure_sequence(options.sequence, true);
  std::optional<SequenceQuality> without;
  if (options.sequence.static_buffer) {
    SequenceOptions sequence = options.sequence;
    sequence.static_buffer = false, sequence.held_planes = true;
    without = measure_sequence(sequence, false);
  }
  if (q.between == 0)
    throw ref::Error(fmt::format("{}: no frame lies between keys: lower --psnr", options.sequence.scene));
  fmt::print("{} {} {}x{}: {} frames, {} keys, {} in between, against these as rendered\n\n{:<20} {:>9} {:>9} {:>8}",
             options.sequence.engine, options.sequence.scene, q.sequence.width, q.sequence.height, q.sequence.frames,
             q.sequence.keys.size(), q.between, "", "PSNR_Y dB", "rendered", "SSIM");
  for (int n = 0; n < ref::kBlockClasses; ++n) fmt::print(" {:>10}", ref::name_of(ref::BlockClass(n)));
  fmt::print("\n");
  print("motion compensated", q.compensated, q.rendered_share());
  if (q.alone) fmt::print("{:<20} {:>9.2f}\n", " its pixels alone", *q.alone);
  if (without) print("without S-buffer", without->compensated, without->rendered_share());
  print("temporal average", q.average);
  print("nearer key", q.repeat);
  if (q.minterpolate) print("ffmpeg minterpolate", *q.minterpolate);
  else fmt::print("{:<20} not measured: {}\n", "ffmpeg minterpolate", q.no_minterpolate);
  const double shown = std::max(1.0, double(q.shares.blended + q.shares.copied + q.shares.filled + q.shares.still));
  fmt::print(
      "\nof covered {} {:.2f} % blended, {:.2f} % copied from one key, {:.2f} % rendered{}; classes are of 4x4 "
      "blocks, from {} dB on\n",
      options.sequence.samples == 1 ? "pixels" : "samples", 100 * double(q.shares.blended) / shown,
      100 * double(q.shares.copied) / shown, 100 * double(q.shares.filled) / shown,
      without ? fmt::format(", {:.2f} % of the S-buffer", 100 * double(q.shares.still) / shown) : "",
      fmt::join(ref::kBlockBorders, ", "));
  fmt::print(
      "rendered: of the covered pixels, those of which a sample was rendered, for want of a key that shows it; its "
      "pixels "
      "alone: the others\n");
  if (q.rendered_share() > 0.1) fmt::print("more than a tenth of the covered pixels is rendered ones\n");
  Json json = {{"scene", options.sequence.scene}, {"engine", options.sequence.engine}};
  json.update(to_json(q));
  if (without) {
    if (options.sequence.engine == "hls") print_work(q, *without);
    json["without_static_buffer"] = to_json(*without);
  }
  write_json(options.json, json);
  if (!options.plot.empty()) plot_blocks(q, options.sequence.scene, options.plot);
}

// "vector_fraction=1..6" as the values to set.
std::vector<std::string> values_of(const std::string& text) {
  const std::size_t sign = text.find('='), dots = text.find("..");
  int first = 0, last = -1;
  if (sign != std::string::npos && dots != std::string::npos && dots > sign) {
    const char* const end = text.data() + text.size();
    const auto a = std::from_chars(text.data() + sign + 1, text.data() + dots, first);
    const auto b = std::from_chars(text.data() + dots + 2, end, last);
    if (a.ec != std::errc() || b.ec != std::errc() || b.ptr != end || a.ptr != text.data() + dots || first < 0 ||
        last > 40)
      last = -1;
  }
  if (last < first) throw ref::Error(fmt::format("--vary {}: write it like vector_fraction=1..6", text));
  std::vector<std::string> values;
  for (int value = first; value <= last; ++value) values.push_back(fmt::format("{}={}", text.substr(0, sign), value));
  return values;
}

// What a number of the motion costs against the floating-point reference.
void vary(const QualityOptions& options) {
  SequenceOptions sequence = options.sequence;
  sequence.engine = "ref";
  const double reference = measure_sequence(sequence, false).compensated.psnr_y;
  fmt::print("{}: PSNR_Y of the floating-point reference {:.2f} dB\n\n{:<24} {:>9} {:>9}\n", sequence.scene, reference,
             "kernels with", "dB", "lost");
  Json rows = Json::array();
  sequence.engine = "hls";
  for (const std::string& value : values_of(options.vary)) {
    sequence.set = options.sequence.set;
    sequence.set.push_back(value);
    const SequenceQuality q = measure_sequence(sequence, false);
    fmt::print("{:<24} {:>9.2f} {:>9.2f}\n", value, q.compensated.psnr_y, reference - q.compensated.psnr_y);
    Json row = {{"set", value}};
    row.update(to_json(q));
    rows.push_back(std::move(row));
  }
  if (!options.plot.empty()) {
    std::string script = fmt::format(
        "set terminal pngcairo size 720,420 noenhanced font 'sans,11' background rgb 'white'\nset title "
        "{}\n"
        "set xlabel {}\nset ylabel 'PSNR_Y of the frames in between, dB'\nset grid\nset key bottom right\nset xtics "
        "1\n$data << EOD\n",
        gnuplot_quoted(sequence.scene), gnuplot_quoted(options.vary.substr(0, options.vary.find('='))));
    for (const Json& row : rows) {
      const std::string set = row["set"];
      script += fmt::format("{} {}\n", set.substr(set.find('=') + 1), row["compensated"]["psnr_y_db"].get<double>());
    }
    script += fmt::format(
        "EOD\nplot {} lw 2 lc rgb '#9aa5ad' title 'reference', $data with linespoints lw 2 pt 7 lc rgb '#2a7d5c' title "
        "'kernels'\n",
        reference);
    run_gnuplot(script, options.plot);
  }
  write_json(options.json, {{"scene", sequence.scene}, {"reference_psnr_y_db", reference}, {"rows", rows}});
}

}  // namespace

void add_quality(CLI::App& app, int&) {
  auto options = std::make_shared<QualityOptions>();
  CLI::App* command = app.add_subcommand("quality", "how near frames between key frames are to these as rendered");
  add_sequence_options(command, options->sequence);
  add_output_file(command, "--plot", options->plot,
                  "picture of the classes of blocks, a frame a bar; with --vary of dB by bits");
  add_json(command, options->json);
  command->footer(
      "  halfspace quality cube_fast                                         the kernels\n"
      "  halfspace quality cube_fast --engine ref --method straight --filter area --no-index-test   as the paper has "
      "it\n"
      "  halfspace quality court --static-buffer                                     with an S-buffer and without, "
      "what both take\n"
      "PSNR_Y is 0.299 PSNR_R + 0.587 PSNR_G + 0.114 PSNR_B, 99 dB at most a channel.\n");
  command->add_option("--vary", options->vary,
                      "a number of the motion's configuration, like vector_fraction=1..6: what fewer bits cost");
  command->callback([options] { options->vary.empty() ? quality(*options) : vary(*options); });
}

}  // namespace halfspace::cli
