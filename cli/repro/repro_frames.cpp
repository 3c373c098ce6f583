// SPDX-License-Identifier: Apache-2.0
#include "cli/repro/repro_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/table.hpp"
#include "cli/plots/sequence_quality.hpp"
#include "cli/plots/video.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

// The paper's animations, dB; ours stand for them. How large its objects are in the frame and how fast they move is not
// printed: with the zoom and the speed of ours the temporal average is within 1 dB of the paper's.
struct Printed {
  const char* animation;
  double average, compensated;
  const char* scene;
  double zoom, speed;
};
constexpr Printed kPrinted[] = {{"TieFighter", 22.96, 36.17, "drone", 0.85, 1},
                                {"F14 Tomcat", 23.13, 34.54, "jet", 1.1, 1.5},
                                {"Cube, fast zoom in and out", 20.12, 33.53, "cube_zoom", 1.85, 1},
                                {"Cube, fast rotation", 16.92, 29.97, "cube_fast", 1.6, 1.2},
                                {"Cube, slow rotation", 22.75, 31.05, "cube_slow", 1.6, 2},
                                {"Pyramid, fast rotation", 15.77, 33.56, "pyramid_fast", 1.3, 2.5},
                                {"Pyramid, slow rotation", 22.57, 31.54, "pyramid_slow", 1.3, 1.6},
                                {"Wheel, in-out motion", 30.25, 39.91, "wheel_in_out", 1.2, 1},
                                {"Wheel, rotation", 23.35, 34.05, "wheel_turn", 0.8, 1},
                                {"Falling ring", 19.33, 26.64, "ring_fall", 1, 2.2}};

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

// As the animations are, or scaled as above.
enum class Scale { kOurs, kPaper };
constexpr Scale kScales[] = {Scale::kPaper, Scale::kOurs};
const char* name_of(Scale scale) { return scale == Scale::kPaper ? "paper" : "ours"; }

struct ReproFramesOptions {
  std::vector<std::string> kinds;
  std::string scale = "both", size = "320x240", out, json;
  int frames = 0;
  bool full = false;
  TableOptions tables;
};

SequenceOptions sequence_of(const ReproFramesOptions& options, const Printed& row, const Kind& kind, Scale scale) {
  SequenceOptions sequence;
  sequence.scene = row.scene;
  sequence.size = options.size;
  sequence.frames = options.frames;
  sequence.texture = kind.texture;
  sequence.samples = kind.samples;
  if (scale == Scale::kPaper) sequence.zoom = row.zoom, sequence.speed = row.speed;
  return sequence;
}

// The paper's own method: weights by area, no test of what a place shows, and vertices on straight lines, its first
// way, or where they are, its second.
SequenceOptions as_printed(SequenceOptions sequence, const char* method) {
  sequence.engine = "ref";
  sequence.method = method;
  sequence.relight = false;
  sequence.filter = "area";
  sequence.index_test = false;
  return sequence;
}

// An animation by each way. What no paper has comes to the exact positions one after the other: the test of the index,
// what no key shows rendered, light.
struct Animation {
  const Printed* printed;
  SequenceOptions options;
  SequenceQuality kernels, straight, exact, reference;  // straight, exact: as printed
  SequenceQuality tested, holes, relit, finer;          // finer: the kernels, of keys of twice the size
};

std::string decibel(double value) { return fmt::format("{:.2f}", value); }

Table table_of_psnr(const std::vector<Animation>& animations, const std::string& heading) {
  Table table{"psnr",
              heading,
              {{"the paper's", "average", "compensated", "ours", "zoom", "speed", "average", "as paper: straight",
                "exact", "minterpolate", "reference", "kernels"}}};
  std::array<double, 8> sum{};
  bool all_interpolated = true;
  const auto row = [&](const std::string& animation, const std::vector<std::string>& scene,
                       const std::array<double, 8>& numbers, bool interpolated) {
    std::vector<std::string> cells = {animation, decibel(numbers[0]), decibel(numbers[1])};
    cells.insert(cells.end(), scene.begin(), scene.end());
    for (std::size_t n = 2; n < numbers.size(); ++n)
      cells.push_back(n == 5 && !interpolated ? "–" : decibel(numbers[n]));
    table.rows.push_back(std::move(cells));
  };
  for (const Animation& a : animations) {
    const bool interpolated = a.kernels.minterpolate.has_value();
    all_interpolated = all_interpolated && interpolated;
    const std::array<double, 8> numbers = {a.printed->average,
                                           a.printed->compensated,
                                           a.kernels.average.psnr_y,
                                           a.straight.compensated.psnr_y,
                                           a.exact.compensated.psnr_y,
                                           interpolated ? a.kernels.minterpolate->psnr_y : 0,
                                           a.reference.compensated.psnr_y,
                                           a.kernels.compensated.psnr_y};
    for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += numbers[n] / double(animations.size());
    row(a.printed->animation, {a.printed->scene, fmt::format("{}", a.options.zoom), fmt::format("{}", a.options.speed)},
        numbers, interpolated);
  }
  row("mean", {"", "", ""}, sum, all_interpolated);
  return table;
}

// The paper's method like for like, and what each thing that it has not is worth on top of it.
Table table_of_steps(const std::vector<Animation>& animations, const std::string& heading) {
  Table table{"steps",
              heading,
              {{"", "the paper's", "ours", "gain", "pixels of keys alone", "rendered", "most of an animation"}}};
  double last = 0;
  const auto row = [&](const std::string& name, const std::string& printed, auto of, bool first = false) {
    double psnr = 0, alone = 0, share = 0, most = 0;
    for (const Animation& a : animations) {
      const SequenceQuality& q = of(a);
      psnr += q.compensated.psnr_y / double(animations.size());
      alone += q.alone.value_or(ref::kMostDecibels) / double(animations.size());
      share += q.rendered_share() / double(animations.size());
      most = std::max(most, q.rendered_share());
    }
    table.rows.push_back({name, printed, decibel(psnr), first ? "" : fmt::format("{:+.2f}", psnr - last),
                          decibel(alone), fmt::format("{:.2f} %", 100 * share), fmt::format("{:.2f} %", 100 * most)});
    last = psnr;
  };
  double compensated = 0, average = 0, printed = 0;
  for (const Animation& a : animations) {
    compensated += a.printed->compensated / double(animations.size());
    printed += a.printed->average / double(animations.size());
    average += a.kernels.average.psnr_y / double(animations.size());
  }
  using A = const Animation&;
  row(
      "like for like: straight lines, weights by area", decibel(compensated), [](A a) -> auto& { return a.straight; },
      true);
  row(
      "exact positions", "", [](A a) -> auto& { return a.exact; });
  row(
      "test of the index", "", [](A a) -> auto& { return a.tested; });
  row(
      "holes are rendered", "", [](A a) -> auto& { return a.holes; });
  row(
      "relighting", "", [](A a) -> auto& { return a.relit; });
  row(
      "bilinear weights", "", [](A a) -> auto& { return a.reference; });
  row(
      "the same by the kernels", "", [](A a) -> auto& { return a.kernels; });
  row(
      "keys of twice the size, by the kernels", "", [](A a) -> auto& { return a.finer; });
  table.rows.push_back({"temporal average of the keys", decibel(printed), decibel(average), "", "", "", ""});
  return table;
}

// Shares of the classes that the paper gives numbers of: very bad, bad, at least good.
std::vector<std::string> shares(const ref::Quality& quality) {
  const auto& b = quality.blocks;
  const double good = b[std::size_t(ref::BlockClass::kGood)] + b[std::size_t(ref::BlockClass::kVeryGood)];
  std::vector<std::string> cells;
  for (const double part : {b[std::size_t(ref::BlockClass::kVeryBad)], b[std::size_t(ref::BlockClass::kBad)], good})
    cells.push_back(fmt::format("{:.1f} %", 100 * part));
  return cells;
}

Table table_of_blocks(const std::vector<Animation>& animations, const std::string& heading) {
  Table table{
      "blocks",
      heading,
      {{"", "average: very bad", "most of a frame", "bad", "good at least", "straight: very bad", "bad",
        "good at least", "exact: very bad", "bad", "good at least", "kernels: very bad", "bad", "good at least"},
       {"TieFighter, the paper's", "12 %", "25–40 %", "–", "–", "0 %", "7 %, less than", "82 %", "0 %",
        "7 %, less than", "82 %", "–", "–", "–"}}};
  double most_of_all = 0;
  std::array<ref::MeanQuality, 4> means;
  const auto row = [&](const std::string& name, const std::array<ref::Quality, 4>& of, double most) {
    std::vector<std::string> cells = {name};
    for (const ref::Quality& quality : of) {
      for (std::string& cell : shares(quality)) cells.push_back(std::move(cell));
    }
    cells.insert(cells.begin() + 2, fmt::format("{:.1f} %", 100 * most));
    table.rows.push_back(std::move(cells));
  };
  for (const Animation& a : animations) {
    const std::array<ref::Quality, 4> of = {a.kernels.average, a.straight.compensated, a.exact.compensated,
                                            a.kernels.compensated};
    for (std::size_t n = 0; n < means.size(); ++n) means[n].add(of[n]);
    double most = 0;
    for (const auto& frame : a.kernels.average_blocks) most = std::max(most, frame[0]);
    most_of_all = std::max(most_of_all, most);
    row(a.printed->scene, of, most);
  }
  row("mean, most of all", {means[0].mean(), means[1].mean(), means[2].mean(), means[3].mean()}, most_of_all);
  return table;
}

Json json_of(const Animation& a, const Kind& kind, Scale scale) {
  Json json = {{"animation", a.printed->animation},
               {"scene", a.printed->scene},
               {"kind", kind.name},
               {"scale", name_of(scale)},
               {"zoom", a.options.zoom},
               {"speed", a.options.speed},
               {"printed", {{"average_db", a.printed->average}, {"compensated_db", a.printed->compensated}}}};
  json["kernels"] = to_json(a.kernels);
  json["reference"] = to_json(a.reference);
  json["as_printed_straight"] = to_json(a.straight);
  json["as_printed_exact"] = to_json(a.exact);
  if (a.holes.between != 0) {
    json["tested"] = to_json(a.tested), json["holes"] = to_json(a.holes);
    json["relit"] = to_json(a.relit), json["finer_keys"] = to_json(a.finer);
  }
  return json;
}

bool wants_steps(const ReproFramesOptions& options) {
  return options.tables.only.empty() || options.tables.only == "steps";
}

std::vector<Animation> measure_kind(const ReproFramesOptions& options, const Kind& kind, Scale scale) {
  std::vector<Animation> animations;
  Progress progress(fmt::format("repro C: {}, scale {}: animations", kind.title, name_of(scale)));
  for (const Printed& row : kPrinted) {
    progress.tell(animations.size(), std::size(kPrinted));
    SequenceOptions sequence = sequence_of(options, row, kind, scale);
    Animation& a = animations.emplace_back(Animation{&row, sequence, {}, {}, {}, {}, {}, {}, {}, {}});
    a.kernels = measure_sequence(sequence, true);
    a.straight = measure_sequence(as_printed(sequence, "straight"), false);
    a.exact = measure_sequence(as_printed(sequence, "exact"), false);
    if (wants_steps(options)) {
      SequenceOptions step = as_printed(sequence, "exact");
      step.index_test = true, step.render_holes = false;
      a.tested = measure_sequence(step, false);
      step.render_holes = true;
      a.holes = measure_sequence(step, false);
      step.relight = true;
      a.relit = measure_sequence(step, false);
      step = sequence;
      step.key_scale = 2;
      a.finer = measure_sequence(step, false);
    }
    sequence.engine = "ref";
    a.reference = measure_sequence(sequence, false);
    if (options.out.empty()) continue;
    const auto plot = [&](const SequenceQuality& quality, const std::string& by) {
      const std::string name = fmt::format("blocks_{}_{}_{}_{}.png", name_of(scale), kind.name, row.scene, by);
      plot_blocks(quality, fmt::format("{}, {}, {}", row.scene, kind.title, by),
                  (std::filesystem::path(options.out) / name).string());
    };
    plot(a.kernels, "kernels"), plot(a.straight, "straight"), plot(a.exact, "exact");
  }
  return animations;
}

// What is measured without --full takes minutes; 4x4 samples take a quarter of an hour.
bool is_wanted(const ReproFramesOptions& options, const Kind& kind) {
  if (options.kinds.empty()) return options.full || kind.samples == 1;
  return std::find(options.kinds.begin(), options.kinds.end(), kind.name) != options.kinds.end();
}

void repro_c(const ReproFramesOptions& options) {
  Json json = {{"paper", "frame-rate up-conversion"}, {"rows", Json::array()}};
  if (!options.out.empty()) model::make_folder(options.out);
  bool first = true;
  for (const Kind& kind : kKinds) {
    for (const Scale scale : kScales) {
      if (!is_wanted(options, kind) || (options.scale != "both" && options.scale != name_of(scale))) continue;
      const std::vector<Animation> animations = measure_kind(options, kind, scale);
      const std::string what = fmt::format(
          "{}, {}, one frame in five drawn, {}", kind.title, options.size,
          scale == Scale::kPaper ? "scaled so that the temporal average is near the paper's" : "as our animations are");
      if (!first) fmt::print("\n");
      std::vector<Table> tables;
      if (wants_steps(options)) {
        tables.push_back(table_of_steps(
            animations, what +
                            "; PSNR_Y in dB of the frames in between, mean of ten.\nRendered: of the covered pixels, "
                            "those of which a sample is, for want of a key that shows it"));
      }
      tables.push_back(table_of_psnr(animations, what + "; PSNR_Y in dB of the frames in between, mean"));
      tables.push_back(table_of_blocks(
          animations, what + "; 4x4 blocks, shares; borders of the classes are ours: 20, 25, "
                             "30, 40 dB.\nOf the paper's temporal average 40 % of the blocks are better than good"));
      print_tables(tables, options.tables);
      std::fflush(stdout);
      first = false;
      for (const Animation& a : animations) json["rows"].push_back(json_of(a, kind, scale));
    }
  }
  write_json(options.json, json);
}

}  // namespace

std::vector<std::string> paper_animations() {
  std::vector<std::string> scenes;
  for (const Printed& row : kPrinted) scenes.push_back(row.scene);
  return scenes;
}

void add_repro_frames(CLI::App* repro) {
  auto options = std::make_shared<ReproFramesOptions>();
  CLI::App* paper = repro->add_subcommand("C", "frame-rate up-conversion");
  std::vector<std::string> names;
  for (const Kind& kind : kKinds) names.emplace_back(kind.name);
  paper
      ->add_option("KIND", options->kinds,
                   "gouraud, textured, supersampled, supersampled_textured; default: the first two")
      ->check(CLI::IsMember(names));
  paper->add_flag("--full", options->full, "all four kinds: a quarter of an hour more");
  paper
      ->add_option("--scale", options->scale,
                   "paper: zoom and speed with which the temporal average is the paper's; ours: as `frames` draws "
                   "them; both")
      ->check(CLI::IsMember({"paper", "ours", "both"}))
      ->capture_default_str();
  paper->add_option("--size", options->size, "frame, WxH")->capture_default_str();
  paper->add_option("--frames", options->frames, "of each animation; default: all")->check(above_zero());
  add_output_folder(paper, "--out", options->out, "folder for the plots of blocks");
  add_json(paper, options->json);
  add_table_options(paper, options->tables, {"steps", "psnr", "blocks"});
  paper->callback([options] { repro_c(*options); });
}

}  // namespace halfspace::cli
