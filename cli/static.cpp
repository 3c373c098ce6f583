// SPDX-License-Identifier: Apache-2.0
// halfspace static
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <numeric>

#include "cli/commands.hpp"
#include "cli/common/numbers.hpp"
#include "cli/common/output.hpp"
#include "cli/common/progress.hpp"
#include "cli/common/scene_frames.hpp"
#include "cli/common/scene_input.hpp"
#include "cli/plots/video.hpp"
#include "model/drivers/static_frames.hpp"
#include "model/pipeline/cycles.hpp"
#include "model/texture/texture.hpp"
#include "ref/error.hpp"
#include "ref/objects/static_instances.hpp"

namespace halfspace::cli {
namespace {

struct StaticOptions {
  FrameInput input;
  std::string config, output, json;
  int lanes = 0, buffers = 1;
  bool query = true;
  double clock = 100;  // MHz
};

// Of all frames but the first, which draws everything.
struct Sum {
  std::uint64_t frames = 0, objects = 0, triangles = 0, cycles = 0, all_triangles = 0, all_cycles = 0;
  std::uint64_t started = 0, queries = 0, skipped = 0, redrawn = 0, anew = 0;
};

// The configuration, with numbers of objects for so many where it has none.
model::Configuration numbered(const std::string& name, std::size_t objects) {
  const model::Configuration chosen = model::find_configuration(name.empty() ? "middle" : name);
  Config c = chosen.config();
  if (has_objects(c)) return chosen;
  if (!has_depth(c) || has_motion(c)) {
    throw ref::Error(
        fmt::format("configuration {}: what moves is held against the depth of what stands: take one with "
                    "depth, that shades",
                    chosen.name()));
  }
  c.object_bits = bits_for(int(objects));
  if (const Refusal reason = refusal(c); reason != Refusal::kNone) {
    throw ref::Error(fmt::format("configuration {} with numbers of {} objects: {}", chosen.name(), objects,
                                 model::refusal_text(reason)));
  }
  return model::Configuration(chosen.name() + "_objects", c);
}

// Whether something changes that is not a movement of an object: a mesh as it is posed, a material, a light.
bool changed(const ref::Scene& before, const ref::Scene& now, double aspect) {
  const std::vector<bool> same = ref::same_instances(before, now, aspect);
  if (same.size() != now.instances.size()) return true;
  for (std::size_t n = 0; n < same.size(); ++n) {
    if (!same[n] && before.instances[n].to_world == now.instances[n].to_world) return true;
  }
  return false;
}

Picture entries_picture(const std::vector<model::RawEntry>& entries, const FrameSize& size, int bits) {
  ref::Colours colours;
  for (const model::RawEntry& entry : entries) {
    auto& to = colours.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) to[c] = ref::displayed_colour(unsigned(entry.rgb[c]), bits);
    to[3] = 255;
  }
  return picture_of(colours, size.width, size.height);
}

class Pipeline {
 public:
  Pipeline(const model::Configuration& configuration, int lanes)
      : config_(configuration.config()), engine_(model::make_engine(configuration, lanes)) {}

  // Of a frame of hs_pipeline that others of its kind come before and after.
  std::uint64_t cycles(const model::NamedFrame& frame) {
    load_frame(*engine_, config_, frame);
    return model::model_cycles(config_, *engine_, frame.scene, engine_->render(frame.scene)).frame;
  }
  std::size_t fits(const model::NamedFrame& frame) {
    load_frame(*engine_, config_, frame);
    return engine_->fits(frame.scene);
  }
  model::Engine& engine() { return *engine_; }

 private:
  const Config config_;
  std::unique_ptr<model::Engine> engine_;
};

// The scene at the times of the frames.
std::vector<ref::Scene> scenes_of(const FrameInput& input) {
  if (ref::is_tri_file(input.scene))
    throw ref::Error(fmt::format("{}: its triangles lie on the screen: name an animated scene", input.scene));
  const SceneSource source(input.scene, input.choice, input.texture != "none");
  std::vector<ref::Scene> scenes{source.at(0)};
  std::pair<int, int> range{0, int(std::floor(scenes[0].duration * input.rate))};
  if (!input.frames.empty()) range = parse_range(input.frames);
  scenes.clear();
  for (int n = range.first; n <= range.second; ++n) scenes.push_back(source.at(n / input.rate));
  if (scenes.size() < 3 || scenes[0].duration <= 0) {
    throw ref::Error(
        fmt::format("{}: {} frames, and what moves is seen from the third on: take an animated scene and "
                    "more --frames",
                    input.scene, scenes.size()));
  }
  return scenes;
}

void run_static(const StaticOptions& options) {
  const std::vector<ref::Scene> scenes = scenes_of(options.input);
  const FrameSize size = parse_size(options.input.size);
  const double aspect = double(size.width) / size.height;
  const model::Configuration configuration = numbered(options.config, scenes[0].instances.size());
  const Config config = configuration.config();
  std::vector<const ref::Scene*> times;
  for (const ref::Scene& time : scenes) times.push_back(&time);
  // Depths of two frames compare if they are of the same planes.
  const ref::DepthPlanes planes = ref::held_planes(times, aspect);
  const auto scene_at = [&](std::size_t n) {
    ref::Scene scene = *times[n];
    scene.depth_planes = planes;
    if (has_texture(config)) model::fit_textures(scene, config);
    return scene;
  };

  ref::Scene scene = scene_at(0);
  const int lanes = options.lanes ? options.lanes : config.lanes;
  model::StaticFrames method(scene, {configuration, lanes, size.width, size.height, options.buffers, options.query, 0});
  Pipeline pipeline(configuration, lanes);
  std::unique_ptr<FrameWriter> film;
  if (!options.output.empty())
    film = std::make_unique<FrameWriter>(options.output, size.width, size.height,
                                         std::max(1, int(std::lround(options.input.rate))));
  std::vector<std::uint32_t> everything(scene.instances.size());
  for (std::uint32_t n = 0; n < everything.size(); ++n) everything[n] = n;

  Sum sum;
  Json rows = Json::array();
  Progress progress("static " + options.input.scene);
  for (std::size_t n = 0; n < times.size(); ++n) {
    ref::Scene now = scene_at(n);
    if (n > 0 && changed(scene, now, aspect)) method.start_anew();
    scene = std::move(now);
    std::uint64_t cycles = 0;
    model::StaticFramesSink sink;
    sink.pass = [&](const model::NamedFrame& pass) { cycles += pipeline.cycles(pass); };
    const model::StaticFrameWork& work = method.draw(sink);
    cycles += work.run_cycles;

    const model::NamedFrame all = method.triangles(everything);
    if (pipeline.fits(all) < all.scene.triangles.size()) {
      throw ref::Error(fmt::format("{}: {} triangles in frame {}, and configuration {} has {}: raise `triangles`",
                                   options.input.scene, all.scene.triangles.size(), n, configuration.name(),
                                   config.triangles));
    }
    const std::uint64_t all_cycles = pipeline.cycles(all);
    const std::vector<model::RawEntry> expected = model::StaticFrames::entries(pipeline.engine(), configuration, all);
    const auto differ = std::inner_product(expected.begin(), expected.end(), method.picture().begin(), std::size_t(0),
                                           std::plus<>(), [](const auto& a, const auto& b) { return !(a == b); });
    if (differ != 0) {
      throw ref::Error(
          fmt::format("{}: frame {}: {} pixels are not those of drawing everything: please report it with "
                      "the scene",
                      options.input.scene, n, differ));
    }
    if (film) film->write(entries_picture(method.picture(), size, config.colour_bits));
    const std::uint64_t objects = work.moving + work.added + work.redrawn;
    rows.push_back({{"frame", n},
                    {"new_view", work.new_view},
                    {"objects", objects},
                    {"triangles", work.triangles},
                    {"cycles", cycles},
                    {"all_triangles", all.scene.triangles.size()},
                    {"all_cycles", all_cycles},
                    {"started", work.started},
                    {"queries", work.queries},
                    {"skipped", work.skipped}});
    progress.tell(n + 1, times.size());
    // The frame before the first has all objects in motion, and the first draws those that stand into their S-buffer.
    if (n == 0) continue;
    ++sum.frames;
    sum.objects += objects, sum.triangles += work.triangles, sum.cycles += cycles;
    sum.all_triangles += all.scene.triangles.size(), sum.all_cycles += all_cycles;
    sum.started += work.started, sum.queries += work.queries, sum.skipped += work.skipped;
    sum.redrawn += work.redrawn, sum.anew += work.new_view;
  }
  if (film) film->finish();

  const double count = double(sum.frames), hertz = options.clock * 1e6;
  const auto print = [&](const char* what, double objects, double triangles, double cycles) {
    fmt::print("{:<24} {:>9.1f} {:>11.1f} {:>12.0f} {:>10.1f}\n", what, objects / count, triangles / count,
               cycles / count, hertz * count / cycles);
  };
  fmt::print("{} {}x{} {}, {} lanes: {} objects, {} frames after the first; each is that of drawing everything\n\n",
             options.input.scene, size.width, size.height, configuration.name(), lanes, everything.size(), sum.frames);
  fmt::print("{:<24} {:>9} {:>11} {:>12} {:>10}\n", "a frame", "objects", "triangles", "cycles",
             fmt::format("at {:g} MHz", options.clock));
  print("drawing everything", double(everything.size()) * count, double(sum.all_triangles), double(sum.all_cycles));
  print(fmt::format("{} S-buffer{}{}", options.buffers, options.buffers == 1 ? "" : "s", options.query ? ", query" : "")
            .c_str(),
        double(sum.objects), double(sum.triangles), double(sum.cycles));
  fmt::print(
      "\n{} objects began to move; {} were asked for, of which {} were not seen; {} others were drawn again.\n"
      "{} frames began anew, as the view, a light, a material or a mesh changed.\n"
      "Cycles of hs_static_frames by the model of the RTL: one pass after the other, merged as it is scanned out, and\n"
      "the runs without a pass, where memory answers in a cycle.\n",
      sum.started, sum.queries, sum.skipped, sum.redrawn, sum.anew);
  write_json(options.json, {{"scene", options.input.scene},
                            {"config", configuration.name()},
                            {"lanes", lanes},
                            {"objects", everything.size()},
                            {"buffers", options.buffers},
                            {"query", options.query},
                            {"clock_mhz", options.clock},
                            {"cycles", double(sum.cycles) / count},
                            {"all_cycles", double(sum.all_cycles) / count},
                            {"frames_a_second", hertz * count / double(sum.cycles)},
                            {"all_frames_a_second", hertz * count / double(sum.all_cycles)},
                            {"frames", rows}});
}

}  // namespace

void add_static(CLI::App& app, int&) {
  auto options = std::make_shared<StaticOptions>();
  CLI::App* command =
      app.add_subcommand("static", "an animation of which what stands still is drawn once, into an S-buffer");
  add_frame_options(command, options->input);
  options->input.size = "320x240";
  command->add_option("--config", options->config,
                      "of the frames; one without object_bits gets as many as the scene needs; default: middle");
  command->add_option("--lanes", options->lanes, "pixels a stamp; default: those of the configuration");
  command->add_option("--buffers", options->buffers, "S-buffers")->capture_default_str()->check(above_zero());
  command->add_flag("--query,!--no-query", options->query, "an S-buffer is asked before it is changed (default)");
  command->add_option("--clock", options->clock, "MHz, for frames a second")
      ->capture_default_str()
      ->check(above_zero());
  add_output_file(command, "-o,--output", options->output,
                  "a film (.mp4, .mkv, .webm, .gif) or pictures like frame_%04d.png");
  add_json(command, options->json);
  command->footer(
      "  halfspace static court --frames 10:20 --size 160x120      what is drawn, cycles, frames a second\n"
      "  halfspace static court --frames 10:20 --size 160x120 --buffers 3 --no-query --clock 50\n"
      "docs/static.md has the rules. Each frame is held to that of drawing everything, to the bit.\n");
  command->callback([options] { run_static(*options); });
}

}  // namespace halfspace::cli
