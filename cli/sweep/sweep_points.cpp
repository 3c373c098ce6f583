// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_points.hpp"
#include "cli/common/scene_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "cli/common/area.hpp"
#include "cli/common/scene_frames.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

// FNV-1a: names a file by what it holds, and is no guard against malice; what it stands for is in the file as well.
std::string digest(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

SweepScene load_scene(const SweepInput& input, const std::string& name, const FrameSize& size) {
  SweepScene scene{name, size.width, size.height, "", {}};
  if (fs::is_regular_file(name)) scene.digest = digest(bytes_of(name));
  if (!ref::is_tri_file(name)) return scene;
  const auto list = std::make_shared<ref::TriangleList>(ref::read_tri(name));
  if (!input.size.empty() && (size.width != list->width || size.height != list->height)) {
    throw ref::Error(
        fmt::format("{}: its frame is {}x{}, not {}: leave out --size", name, list->width, list->height, input.size));
  }
  scene.width = list->width;
  scene.height = list->height;
  scene.subject = model::Subject(list);
  return scene;
}

// What the configurations of the sweep draw of it.
void load_subject(const Sweep& sweep, SweepScene& scene) {
  if (ref::is_tri_file(scene.name)) {
    if (sweep.motion) throw ref::Error(fmt::format("{}: nothing moves in it: take an animated scene", scene.name));
    return;
  }
  const auto source = std::make_shared<SceneSource>(scene.name, sweep.input.shown);
  if (sweep.motion) {
    if (source->at(0).duration <= 0)
      throw ref::Error(fmt::format("{}: nothing moves in it: take an animated scene", scene.name));
    scene.at = [source](double seconds) { return source->at(seconds); };
    return;
  }
  std::shared_ptr<ref::Scene> textured;
  if (sweep.finest.texture)
    textured = std::make_shared<ref::Scene>(SceneSource(scene.name, sweep.input.shown, true).at(sweep.input.time));
  scene.subject = model::Subject(std::make_shared<ref::Scene>(source->at(sweep.input.time)), std::move(textured));
}

// The finest of each feature that a configuration has; pictures are not ideal without colours that vary.
ref::IdealLook finest_look(const std::vector<SweepConfig>& configs) {
  ref::IdealLook finest;
  for (const SweepConfig& config : configs) {
    if (config.refused.empty()) finest = model::look_of(config.numbers, finest);
  }
  return finest;
}

void make_points(Sweep& sweep) {
  const auto add = [&](bool is_area, std::size_t scene, std::size_t config, Json what) {
    what["configuration"] = to_json(sweep.configs[config].numbers);
    const std::string file = "points/" + digest(what.dump()) + ".json";
    sweep.points.push_back({is_area, scene, config, std::move(what), file});
  };
  const std::string program = digest(bytes_of("/proc/self/exe"));
  for (std::size_t s = 0; s < sweep.scenes.size(); ++s) {
    const SweepScene& scene = sweep.scenes[s];
    for (std::size_t c = 0; c < sweep.configs.size(); ++c) {
      if (!sweep.configs[c].refused.empty()) continue;
      Json what = {{"picture", scene.name},  {"digest", scene.digest},   {"width", scene.width},
                   {"height", scene.height}, {"time", sweep.input.time}, {"program", program}};
      if (sweep.motion) what.update({{"frames", sweep.frames}, {"keys", sweep.configs[c].between}});
      else what["ideal"] = ref::name_of(model::look_of(sweep.configs[c].numbers, sweep.finest));
      add(false, s, c, std::move(what));
    }
  }
  if (sweep.targets.empty()) return;
  const std::string rtl = digest(area_sources());
  for (std::size_t c = 0; c < sweep.configs.size(); ++c) {
    if (sweep.configs[c].refused.empty()) add(true, 0, c, {{"area", sweep.targets}, {"rtl", rtl}});
  }
}

}  // namespace

Sweep plan_sweep(const SweepInput& input) {
  Sweep sweep;
  sweep.input = input;
  std::set<std::string> keys, scenes;
  for (const std::string& option : input.vary) {
    sweep.variations.push_back(parse_variation(option));
    if (!keys.insert(sweep.variations.back().key).second) {
      throw ref::Error(fmt::format("--vary {}: {} is varied already: put all its values in one option", option,
                                   sweep.variations.back().key));
    }
  }
  sweep.targets = area_targets(input.area);
  const Config base = base_numbers(input.choice);
  if (up_converts(base)) {
    throw ref::Error(
        "a configuration with frames_between has the numbers of key frames and of frames in between: sweep "
        "one without it, or one of shading = \"motion\"");
  }
  const FrameSize size = input.size.empty() ? FrameSize{base.width, base.height} : parse_size(input.size);
  for (const std::string& name : input.scenes) {
    if (!scenes.insert(name).second) throw ref::Error(fmt::format("{}: named twice: name each scene once", name));
    sweep.scenes.push_back(load_scene(input, name, size));
    FrameSize& frame = sweep.input.choice.frame;
    frame = {std::max(frame.width, sweep.scenes.back().width), std::max(frame.height, sweep.scenes.back().height)};
  }
  sweep.configs = sweep_configs(sweep.input.choice, sweep.variations);
  sweep.motion = has_motion(base);
  if (sweep.motion) sweep.frames = parse_range(input.frames);
  sweep.finest = finest_look(sweep.configs);
  for (SweepScene& scene : sweep.scenes) load_subject(sweep, scene);
  make_points(sweep);
  return sweep;
}

Json stored_result(const Sweep& sweep, const SweepPoint& point) {
  const fs::path path = fs::path(sweep.input.out) / point.file;
  if (!fs::exists(path)) return nullptr;
  const Json json = Json::parse(bytes_of(path), nullptr, false);
  if (json.is_discarded() || !json.is_object() || json.value("point", Json()) != point.what) return nullptr;
  return json.value("result", Json());
}

}  // namespace halfspace::cli
