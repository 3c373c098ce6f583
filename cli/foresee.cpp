// SPDX-License-Identifier: Apache-2.0
// halfspace foresee
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/commands.hpp"
#include "cli/common/output.hpp"
#include "cli/common/sequence.hpp"
#include "cli/plots/gnuplot.hpp"
#include "cli/repro/repro_frames.hpp"
#include "ref/error.hpp"
#include "ref/motion/quality.hpp"

namespace halfspace::cli {
namespace {

struct ForeseeOptions {
  std::vector<std::string> scenes = paper_animations();
  std::string size = "320x240", keys = "1:4", plot, json;
};

// The frames between two keys, in the mean.
struct ForeseenInterval {
  std::string scene;
  int key;
  double foreseen, measured;
};

// Of numbers that are equal, the mean of theirs.
std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> rank(values.size());
  for (std::size_t from = 0; from < order.size();) {
    std::size_t to = from;
    while (to < order.size() && values[order[to]] == values[order[from]]) ++to;
    for (std::size_t n = from; n < to; ++n) rank[order[n]] = double(from + to - 1) / 2;
    from = to;
  }
  return rank;
}

// Spearman's.
double rank_correlation(const std::vector<ForeseenInterval>& intervals) {
  std::vector<double> foreseen, measured;
  for (const ForeseenInterval& i : intervals) foreseen.push_back(i.foreseen), measured.push_back(i.measured);
  const std::vector<double> a = ranks(foreseen), b = ranks(measured);
  const double mean = (double(a.size()) - 1) / 2;
  double both = 0, of_a = 0, of_b = 0;
  for (std::size_t n = 0; n < a.size(); ++n) {
    both += (a[n] - mean) * (b[n] - mean);
    of_a += (a[n] - mean) * (a[n] - mean), of_b += (b[n] - mean) * (b[n] - mean);
  }
  return of_a > 0 && of_b > 0 ? both / std::sqrt(of_a * of_b) : 0;
}

std::vector<ForeseenInterval> intervals_of(const ForeseeOptions& options, const std::string& scene) {
  SequenceOptions sequence;
  sequence.scene = scene, sequence.size = options.size, sequence.keys = options.keys;
  sequence.foresee = true;
  std::vector<ForeseenInterval> out;
  int frames = 0;
  const auto end = [&] {
    if (frames > 0) out.back().foreseen /= frames, out.back().measured /= frames;
    frames = 0;
  };
  const FrameSize size = parse_size(options.size);
  run_sequence(
      sequence, [&] { out.clear(), frames = 0; },
      [&](const SequenceFrame& frame) {
        if (frame.is_key) return end();
        if (frames++ == 0) out.push_back({scene, frame.number - 1, 0, 0});
        out.back().foreseen += *frame.foreseen;
        out.back().measured += ref::quality(frame.shown, frame.rendered, size.width, size.height).psnr_y;
      });
  end();
  return out;
}

void plot(const std::vector<ForeseenInterval>& intervals, const ForeseeOptions& options) {
  std::string script =
      "set terminal pngcairo size 720,560 noenhanced font 'sans,11' background rgb 'white'\n"
      "set xlabel 'foreseen PSNR_Y of the frames between two keys, dB'\nset ylabel 'measured, dB'\nset grid\n"
      "set key outside right top\nset xrange [35:101]\nset yrange [35:101]\n";
  std::string curves;
  int number = 0;
  for (const std::string& scene : options.scenes) {
    script += fmt::format("$s{} << EOD\n", number);
    for (const ForeseenInterval& i : intervals) {
      if (i.scene == scene) script += fmt::format("{} {}\n", i.foreseen, i.measured);
    }
    script += "EOD\n";
    curves += fmt::format(", $s{0} with points pt {1} lc {2} title {3}", number, number + 1, number % 8 + 1,
                          gnuplot_quoted(scene));
    ++number;
  }
  run_gnuplot(script + "plot x with lines lc rgb '#9aa5ad' title 'as foreseen'" + curves + "\n", options.plot);
}

void foresee(const ForeseeOptions& options) {
  std::vector<ForeseenInterval> all;
  fmt::print("{:<20} {:>9} {:>12} {:>12}\n", options.size, "intervals", "foreseen dB", "measured dB");
  Json rows = Json::array();
  for (const std::string& scene : options.scenes) {
    const std::vector<ForeseenInterval> found = intervals_of(options, scene);
    double foreseen = 0, measured = 0;
    for (const ForeseenInterval& i : found) {
      foreseen += i.foreseen / double(found.size()), measured += i.measured / double(found.size());
      rows.push_back({{"scene", scene}, {"key", i.key}, {"foreseen_db", i.foreseen}, {"measured_db", i.measured}});
    }
    fmt::print("{:<20} {:>9} {:>12.1f} {:>12.1f}\n", scene, found.size(), foreseen, measured);
    all.insert(all.end(), found.begin(), found.end());
  }
  double squares = 0;
  for (const ForeseenInterval& i : all) squares += (i.foreseen - i.measured) * (i.foreseen - i.measured);
  const double rank = rank_correlation(all), off = std::sqrt(squares / double(all.size()));
  fmt::print("\n{} intervals: rank correlation {:.3f}; off by {:.1f} dB (root of the mean square)\n", all.size(), rank,
             off);
  if (!options.plot.empty()) plot(all, options);
  write_json(options.json, {{"keys", options.keys}, {"rank_correlation", rank}, {"off_db", off}, {"intervals", rows}});
}

}  // namespace

void add_foresee(CLI::App& app, int&) {
  auto options = std::make_shared<ForeseeOptions>();
  CLI::App* command = app.add_subcommand(
      "foresee", "how near frames between key frames will be, from their motion alone, beside how near they are");
  command->add_option("SCENE", options->scenes, "animated scenes; default: the ten that stand for the paper's");
  command->add_option("--keys", options->keys, "key frames to frames in between, 1:1 … 1:9")->capture_default_str();
  command->add_option("--size", options->size, "frame, WxH")->capture_default_str();
  add_output_file(command, "--plot", options->plot, "picture of both, an interval a point");
  add_json(command, options->json);
  command->footer(
      "  halfspace foresee cube_fast jet --size 160x120    both, and how well they agree\n"
      "  halfspace foresee --plot foreseen.png             the picture of docs/frames.md\n");
  command->callback([options] { foresee(*options); });
}

}  // namespace halfspace::cli
