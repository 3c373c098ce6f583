// SPDX-License-Identifier: Apache-2.0
// halfspace holes
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/table.hpp"
#include "cli/plots/sequence_quality.hpp"
#include "cli/repro/repro_frames.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

// Wanted of the pixels that are made of keys alone, mean over the scenes, dB; and the most that may be rendered.
struct Goal {
  const char* name;
  const char* title;
  int samples;
  const char* texture;
  double decibels, rendered;
};
constexpr Goal kGoals[] = {{"gouraud", "Gouraud", 1, "none", 60, 0.03},
                           {"textured", "textured", 1, "bilinear", 44, 0.03},
                           {"supersampled", "Gouraud, 4x4 samples", 4, "none", 50, 0.1},
                           {"supersampled_textured", "textured, 4x4 samples", 4, "bilinear", 45, 0.1}};

// What a key pixel keeps, and how many there are for a pixel, each way.
struct Keys {
  ref::KeyFaces faces;
  int scale;
};
constexpr Keys kKeys[] = {{ref::KeyFaces::kPure, 1}, {ref::KeyFaces::kMost, 1}, {ref::KeyFaces::kTwo, 1},
                          {ref::KeyFaces::kMost, 2}, {ref::KeyFaces::kTwo, 2},  {ref::KeyFaces::kTwo, 4}};

struct HolesOptions {
  std::vector<std::string> scenes = paper_animations(), kinds;
  std::string engine = "hls", size = "320x240", filter, json;
  int step = 6;
  std::vector<int> scales = {1, 2};
  std::vector<std::string> faces = {"pure", "most", "two"};
  TableOptions tables;
};

// Of one scene.
struct OfScene {
  std::string scene;
  int frames = 0;
  double psnr = 0, alone = 0;  // mean over the frames
  ref::Shares shares;
  double rendered() const { return shares.pixels ? double(shares.rendered) / double(shares.pixels) : 0; }
  double filled() const {
    const double all = double(shares.blended + shares.copied + shares.filled);
    return all > 0 ? double(shares.filled) / all : 0;
  }
};

OfScene measure(const HolesOptions& options, const std::string& scene, const Goal& goal, const Keys& keys) {
  constexpr int kInterval = 5;  // frames from a key to the next
  OfScene out;
  out.scene = scene;
  SequenceOptions sequence;
  sequence.scene = scene, sequence.size = options.size, sequence.engine = options.engine;
  sequence.texture = goal.texture, sequence.samples = goal.samples, sequence.filter = options.filter;
  sequence.key_faces = ref::name_of(keys.faces), sequence.key_scale = keys.scale;
  sequence.frames = kInterval + 1;
  const SceneSource source(scene, {});
  const int frames = int(std::floor(source.at(0).duration * kFramesASecond)) + 1;
  int alone = 0;
  const int last = std::max(0, frames - sequence.frames), from = std::min(kInterval * (options.step / 2), last);
  for (sequence.first = from; sequence.first <= last; sequence.first += kInterval * options.step) {
    const SequenceQuality q = measure_sequence(sequence, false);
    out.frames += q.between;
    out.psnr += q.compensated.psnr_y * q.between;
    if (q.alone) out.alone += *q.alone * q.between, alone += q.between;
    add(out.shares, q.shares);
  }
  out.psnr /= std::max(out.frames, 1), out.alone /= std::max(alone, 1);
  return out;
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

void holes(const HolesOptions& options) {
  Table summary{"summary", "", {}}, scenes{"scenes", "Each scene", {}};
  summary.rows.push_back({"", "goal", "key faces", "key scale", "PSNR_Y", "alone", "least of a scene", "rendered",
                          "most of a scene", "samples", "most of a scene"});
  scenes.rows.push_back({"scene", "", "key faces", "key scale", "PSNR_Y", "alone", "rendered", "samples"});
  Json rows = Json::array();
  int frames = 0;
  Progress progress("holes: kinds and keys");
  std::size_t done = 0;
  for (const Goal& goal : kGoals) {
    if (!options.kinds.empty() &&
        std::find(options.kinds.begin(), options.kinds.end(), goal.name) == options.kinds.end())
      continue;
    for (const Keys& keys : kKeys) {
      // A pixel of one sample shows one face.
      if (keys.faces != ref::KeyFaces::kTwo && goal.samples <= keys.scale) continue;
      if (std::find(options.scales.begin(), options.scales.end(), keys.scale) == options.scales.end() ||
          std::find(options.faces.begin(), options.faces.end(), ref::name_of(keys.faces)) == options.faces.end())
        continue;
      progress.tell(done++, std::size(kGoals) * 3);
      std::vector<OfScene> all;
      for (const std::string& scene : options.scenes) all.push_back(measure(options, scene, goal, keys));
      const auto mean = [&](auto of) {
        double sum = 0;
        for (const OfScene& s : all) sum += of(s);
        return sum / double(all.size());
      };
      const auto by = [](auto of) { return [of](const OfScene& a, const OfScene& b) { return of(a) < of(b); }; };
      const auto psnr = [](const OfScene& s) { return s.psnr; };
      const auto alone = [](const OfScene& s) { return s.alone; };
      const auto rendered = [](const OfScene& s) { return s.rendered(); };
      const auto filled = [](const OfScene& s) { return s.filled(); };
      const OfScene& worst = *std::min_element(all.begin(), all.end(), by(alone));
      const OfScene& most = *std::max_element(all.begin(), all.end(), by(rendered));
      const OfScene& most_filled = *std::max_element(all.begin(), all.end(), by(filled));
      const std::string kept = goal.samples <= keys.scale ? "" : ref::name_of(keys.faces);
      const bool met = mean(alone) >= goal.decibels && most.rendered() <= goal.rendered;
      summary.rows.push_back(
          {goal.title,
           fmt::format("{:.0f} dB, {:.0f} %: {}", goal.decibels, 100 * goal.rendered, met ? "met" : "missed"), kept,
           fmt::format("{}", keys.scale), fmt::format("{:.2f}", mean(psnr)), fmt::format("{:.2f}", mean(alone)),
           fmt::format("{:.2f} ({})", worst.alone, worst.scene), percent(mean(rendered)),
           fmt::format("{} ({})", percent(most.rendered()), most.scene), percent(mean(filled)),
           percent(most_filled.filled())});
      frames = 0;
      for (const OfScene& s : all) {
        frames += s.frames;
        scenes.rows.push_back({s.scene, goal.title, kept, fmt::format("{}", keys.scale), fmt::format("{:.2f}", s.psnr),
                               fmt::format("{:.2f}", s.alone), percent(s.rendered()), percent(s.filled())});
        rows.push_back({{"scene", s.scene},
                        {"kind", goal.name},
                        {"key_faces", ref::name_of(keys.faces)},
                        {"key_scale", keys.scale},
                        {"frames", s.frames},
                        {"psnr_y_db", s.psnr},
                        {"of_keys_alone_psnr_y_db", s.alone},
                        {"rendered_share", s.rendered()},
                        {"rendered_samples_share", s.filled()}});
      }
    }
  }
  if (rows.empty()) throw ref::Error("holes: no kind has such keys: leave --key-faces or --key-scale out");
  summary.heading = fmt::format(
      "{}, {}: means over {} scenes, {} frames in between. alone: of the pixels that are made of keys alone; rendered: "
      "of\nthe covered pixels, those of which a sample is rendered; samples: that are rendered. A goal is of the mean, "
      "and of the\nmost that is rendered of a scene",
      options.engine, options.size, options.scenes.size(), frames);
  print_tables({summary, scenes}, options.tables);
  write_json(options.json, {{"engine", options.engine}, {"size", options.size}, {"rows", rows}});
}

}  // namespace

void add_holes(CLI::App& app, int&) {
  auto options = std::make_shared<HolesOptions>();
  CLI::App* command = app.add_subcommand(
      "holes", "PSNR of frames between key frames beside what of them is rendered, by what key frames keep; and goals");
  std::vector<std::string> names;
  for (const Goal& goal : kGoals) names.emplace_back(goal.name);
  command->add_option("KIND", options->kinds, "gouraud, textured, supersampled, supersampled_textured; default: all")
      ->check(CLI::IsMember(names));
  command->add_option("--scene", options->scenes, "animated scenes; default: the ten that stand for the paper's");
  command->add_option("--engine", options->engine, "ref: floating-point reference; hls: fixed-point kernels")
      ->check(CLI::IsMember({"ref", "hls"}))
      ->capture_default_str();
  command->add_option("--step", options->step, "of how many intervals of a scene one is measured; 1: all")
      ->capture_default_str()
      ->check(above_zero());
  command->add_option("--size", options->size, "frame, WxH")->capture_default_str();
  command->add_option("--filter", options->filter, "of key frames")
      ->check(CLI::IsMember({"nearest", "bilinear", "area", "bicubic"}));
  command->add_option("--key-scale", options->scales, "pixels of a key frame for one of a frame, each way: 1, 2, 4")
      ->check(CLI::IsMember({1, 2, 4}))
      ->capture_default_str();
  command->add_option("--key-faces", options->faces, "what a key pixel keeps: pure, most, two")
      ->check(CLI::IsMember({"pure", "most", "two"}))
      ->capture_default_str();
  add_json(command, options->json);
  add_table_options(command, options->tables, {"summary", "scenes"});
  command->footer(
      "  halfspace holes                                       the table of docs/frames.md, in minutes\n"
      "  halfspace holes gouraud --scene jet --size 80x60      one scene\n");
  command->callback([options] { holes(*options); });
}

}  // namespace halfspace::cli
