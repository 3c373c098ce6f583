// SPDX-License-Identifier: Apache-2.0
// halfspace shrink: the smallest frame on which a bench still fails.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_input.hpp"
#include "cli/common/shell.hpp"
#include "ref/error.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "vectors/staging.hpp"
#include "vectors/standard_set.hpp"
#include "vectors/vector_set.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

struct ShrinkOptions {
  SceneInput input;
  std::string bench, out, json;
  int lanes = 4, stall = 0, frames = 2;
  std::uint64_t seed = 1, hang = 5000;
  double seconds = 45;
  int random = 4, random_triangles = 60;  // of SCENE `standard`
  std::uint64_t frame_seed = 1;
};

// What a bench is run on.
struct Trial {
  std::vector<model::NamedFrame> set;
  int stall, frames;
  std::size_t triangles(std::size_t frame) const { return set[frame].scene.triangles.size(); }
  std::size_t triangles() const {
    std::size_t all = 0;
    for (std::size_t frame = 0; frame < set.size(); ++frame) all += triangles(frame);
    return all;
  }
};

template <class T>
void keep(std::vector<T>& all, const std::vector<std::size_t>& kept, std::size_t count) {
  if (all.size() != count) return;  // the configuration has no such thing
  std::vector<T> fewer;
  for (const std::size_t n : kept) fewer.push_back(all[n]);
  all = std::move(fewer);
}

// Without these triangles of a frame.
Trial without(Trial trial, std::size_t frame, std::size_t begin, std::size_t end) {
  const std::size_t count = trial.triangles(frame);
  std::vector<std::size_t> kept;
  for (std::size_t n = 0; n < count; ++n) {
    if (n < begin || n >= end) kept.push_back(n);
  }
  model::NamedFrame& of = trial.set[frame];
  keep(of.lighting.triangles, kept, count);
  keep(of.texture.triangles, kept, count);
  keep(of.motion.triangles, kept, count);
  keep(of.objects, kept, count);
  keep(of.scene.triangles, kept, count);
  return trial;
}

Trial without_frames(Trial trial, std::size_t begin, std::size_t end) {
  trial.set.erase(trial.set.begin() + std::ptrdiff_t(begin), trial.set.begin() + std::ptrdiff_t(end));
  return trial;
}

// One frame, moved by whole pixels.
Trial moved(Trial trial, int x, int y) {
  ref::SnappedList& scene = trial.set[0].scene;
  const int one = 1 << scene.format.subpixel_bits;
  for (ref::SnappedTriangle& t : scene.triangles) {
    for (std::int32_t& value : t.x) value -= x * one;
    for (std::int32_t& value : t.y) value -= y * one;
  }
  return trial;
}

// A stream without a word is a failure too, but of the set.
bool is_wrong(const Json& run) {
  const Json& failures = run["failures"];
  return std::any_of(failures.begin(), failures.end(),
                     [](const Json& failure) { return failure.get<std::string>().rfind("empty: ", 0) != 0; });
}

class Shrinker {
 public:
  Shrinker(const ShrinkOptions& options, model::VectorSetOptions set)
      : options_(options), set_(std::move(set)), progress_("shrink " + set_.scene) {}

  Trial run(const Trial& whole) {
    model::make_folder(options_.out);
    best_ = whole;
    if (!fails(whole)) {
      throw ref::Error(fmt::format("{} does not fail on {}: there is nothing to shrink", options_.bench, set_.scene));
    }
    guilty_ = said_;
    if (whole.frames > 1) attempt([&](Trial& t) { t.frames = 1; });
    fewer_frames();
    fewer_stalls();
    fewer_triangles();
    if (best_.set.size() == 1) smaller_frame();
    fewer_triangles();
    fewer_stalls();
    return best_;
  }

  std::string command(const Trial& trial) const {
    std::string text = fmt::format("{} {} --seed {} --stall {} --hang {}", shell_quoted(options_.bench),
                                   shell_quoted((fs::path(options_.out) / "vectors").string()), options_.seed,
                                   trial.stall, options_.hang);
    if (is_pipeline_) text += fmt::format(" --frames {}", trial.frames);
    return text;
  }
  // Leaves the set of a trial in the folder, and runs the bench on it. Whether it fails, and with the unit that failed
  // at first: another fault is not the same one.
  bool fails(const Trial& trial) {
    ++trials_;
    const fs::path out(options_.out), report = out / "cosim.json";
    model::write_vector_set((out / "vectors").string(), set_, trial.set, nullptr);
    fs::remove(report);
    const auto call = [&] {
      const std::string words = command(trial) + " --json " + shell_quoted(report.string());
      return std::system((words + " > " + shell_quoted((out / "bench.log").string()) + " 2>&1").c_str());
    };
    int status = call();
    if (!is_known_ && !fs::exists(report)) is_pipeline_ = false, status = call();  // a unit takes no --frames
    std::ifstream file(report);
    const Json json = Json::parse(file, nullptr, false);
    if (!file || json.is_discarded()) {
      if (is_known_) return false;  // the bench does not take such a set
      throw ref::Error(
          fmt::format("{} ended with status {}: read {}", options_.bench, status, (out / "bench.log").string()));
    }
    is_known_ = true;
    const Json& run = json["runs"][0];
    said_ = run.value("first_wrong", "");
    return is_wrong(run) && (guilty_.empty() || said_.empty() || said_ == guilty_);
  }
  int trials() const { return trials_; }
  const std::string& guilty() const { return guilty_; }

 private:
  bool has_time() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() < options_.seconds;
  }

  bool attempt(const Trial& trial) {
    if (!has_time() || !fails(trial)) return false;
    best_ = trial;
    progress_.tell(0, best_.triangles());
    return true;
  }
  template <class Change>
  auto attempt(Change change) -> decltype(change(std::declval<Trial&>()), bool()) {
    Trial trial = best_;
    change(trial);
    return attempt(trial);
  }

  void fewer_stalls() {
    if (best_.stall == 0 || attempt([](Trial& t) { t.stall = 0; })) return;
    while (best_.stall > 1 && attempt([](Trial& t) { t.stall /= 2; })) {}
  }

  // Leaves out parts of `count` things, half of all at first and then ever smaller ones: from the end on, as the first
  // failure is rarely of the last. One stays.
  template <class Count, class Without>
  void fewer(Count count, Without without) {
    for (std::size_t part = (count() + 1) / 2; part > 0 && count() > 1; part /= 2) {
      for (std::size_t end = count(); end > 0 && has_time();) {
        const std::size_t begin = end > part ? end - part : 0;
        if (end - begin < count()) attempt(without(begin, end));
        end = std::min(begin, count());
      }
    }
  }
  void fewer_frames() {
    fewer([&] { return best_.set.size(); },
          [&](std::size_t begin, std::size_t end) { return without_frames(best_, begin, end); });
  }
  void fewer_triangles() {
    for (std::size_t frame = 0; frame < best_.set.size(); ++frame) {
      fewer([&] { return best_.triangles(frame); },
            [&](std::size_t begin, std::size_t end) { return without(best_, frame, begin, end); });
    }
  }

  // Near the upper left corner, and then the least width and height by halving what is left between.
  void smaller_frame() {
    std::int64_t left = INT32_MAX, top = INT32_MAX;
    for (const ref::SnappedTriangle& t : best_.set[0].scene.triangles) {
      left = std::min<std::int64_t>(left, *std::min_element(t.x.begin(), t.x.end()));
      top = std::min<std::int64_t>(top, *std::min_element(t.y.begin(), t.y.end()));
    }
    // Whole stamps of any size, 4 by 4 at most, so that pixels keep their lanes.
    const int f = best_.set[0].scene.format.subpixel_bits;
    const int x = std::max<int>(0, int(left >> f) & ~3), y = std::max<int>(0, int(top >> f) & ~3);
    if (best_.triangles() != 0 && (x || y) && !attempt(moved(best_, x, y))) {
      if (x) attempt(moved(best_, x, 0));
      if (y) attempt(moved(best_, 0, y));
    }
    for (const bool wide : {true, false}) {
      int most = wide ? best_.set[0].scene.width : best_.set[0].scene.height, least = 1;
      while (least < most && has_time()) {
        const int middle = (least + most) / 2;
        const bool small = attempt([&](Trial& t) { (wide ? t.set[0].scene.width : t.set[0].scene.height) = middle; });
        (small ? most : least) = small ? middle : middle + 1;
      }
    }
  }

  const ShrinkOptions& options_;
  const model::VectorSetOptions set_;
  Progress progress_;
  Trial best_{};
  std::string guilty_, said_;
  int trials_ = 0;
  bool is_pipeline_ = true, is_known_ = false;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// SCENE, or the frames of `halfspace vectors standard`.
Trial whole_of(const ShrinkOptions& options, model::Configuration& configuration) {
  if (options.input.scene == "standard") {
    configuration = model::find_configuration(options.input.config.empty() ? "middle" : options.input.config);
    return {model::standard_frames(configuration, options.frame_seed, options.random, options.random_triangles),
            options.stall, options.frames};
  }
  const LoadedScene loaded = load_snapped(options.input);
  configuration = loaded.configuration;
  const Config config = configuration.config();
  model::NamedFrame frame{options.input.scene, loaded.list};
  if (has_lighting(config)) frame.lighting = lighting_of(loaded);
  if (has_texture(config)) frame.texture = texture_of(loaded);
  if (has_motion(config)) frame.motion = motion_of(loaded);
  return {{frame}, options.stall, options.frames};
}

int shrink(const ShrinkOptions& options) {
  model::VectorSetOptions set;
  const Trial whole = whole_of(options, set.configuration);
  set.scene = short_name(options.input.scene);
  set.lanes = options.lanes;
  Shrinker shrinker(options, set);
  const Trial least = shrinker.run(whole);
  const bool still = shrinker.fails(least);  // what stays in the folder is of the smallest
  const fs::path out(options.out);
  // Of several frames the set alone says what follows what.
  if (least.set.size() == 1) {
    std::ostringstream tri;
    ref::write_tri(tri, ref::unsnap(least.set[0].scene));
    model::write_file((out / "smallest.tri").string(), tri.str());
  }
  model::write_file((out / "repeat.sh").string(), shrinker.command(least) + "\n");
  const ref::SnappedList &was = whole.set.back().scene, &is = least.set.back().scene;
  const std::string told = fmt::format(
      "{} triangles → {}, {}x{} → {}x{}, stalls {} % → {} %, frames {} → {}, in {} trials{}", whole.triangles(),
      least.triangles(), was.width, was.height, is.width, is.height, whole.stall, least.stall,
      whole.set.size() + std::size_t(whole.frames) - 1, least.set.size() + std::size_t(least.frames) - 1,
      shrinker.trials(), shrinker.guilty().empty() ? "" : "; first wrong: " + shrinker.guilty());
  fmt::print("{}\n", told);
  if (least.set.size() == 1) fmt::print("{}\n", (out / "smallest.tri").string());
  fmt::print("{}\nrepeat it: {}\n", (out / "vectors").string(), shrinker.command(least));
  write_json(options.json, {{"triangles", least.triangles()},
                            {"width", is.width},
                            {"height", is.height},
                            {"stall", least.stall},
                            {"frames", least.set.size() + std::size_t(least.frames) - 1},
                            {"trials", shrinker.trials()},
                            {"first_wrong", shrinker.guilty()},
                            {"command", shrinker.command(least)}});
  return still ? 0 : 1;
}

}  // namespace

void add_shrink(CLI::App& app, int& status) {
  auto options = std::make_shared<ShrinkOptions>();
  CLI::App* command = app.add_subcommand("shrink", "the smallest frame on which a bench still fails");
  command->footer(
      "Give the bench that fails on SCENE, with the configuration, lanes, stalls and seed that it fails with; a "
      "failed\n"
      "`make cosim` prints the whole line. `standard` stands for the frames of `halfspace vectors standard`, of which\n"
      "the fewest that fail are looked for first. Left in OUT: smallest.tri if it is one frame, the vector set\n"
      "vectors/, what the bench said of it in bench.log, and repeat.sh. Exit status 0: it still fails.\n");
  add_scene_options(command, options->input);
  command->add_option("--bench", options->bench, "the program: a tb_… of the build, or what tb/model.py made")
      ->required();
  command->add_option("--lanes", options->lanes, "of the bench")->capture_default_str();
  command->add_option("--stall", options->stall, "percent")->capture_default_str()->check(CLI::Range(0, 90));
  command->add_option("--seed", options->seed, "of the stalls")->capture_default_str();
  command->add_option("--frames", options->frames, "times that the pipeline draws it")->capture_default_str();
  command->add_option("--random", options->random, "of `standard`: random frames")->capture_default_str();
  command->add_option("--random-triangles", options->random_triangles, "of `standard`: triangles of a random frame")
      ->capture_default_str();
  command->add_option("--frame-seed", options->frame_seed, "of `standard`: its --seed")->capture_default_str();
  command->add_option("--hang", options->hang, "cycles without a word that count as a hang")->capture_default_str();
  command->add_option("--seconds", options->seconds, "to try for")->capture_default_str()->check(above_zero());
  add_output_folder(command, "--out", options->out, "folder to write")->required();
  add_json(command, options->json, "what is left");
  command->callback([options, &status] { status = shrink(*options); });
}

}  // namespace halfspace::cli
