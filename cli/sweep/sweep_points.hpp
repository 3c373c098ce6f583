// SPDX-License-Identifier: Apache-2.0
// The points of a sweep: every configuration on every scene, and the area of every configuration. Each is computed
// without the others and kept in a file of its own.
#ifndef HALFSPACE_CLI_SWEEP_SWEEP_POINTS_HPP_
#define HALFSPACE_CLI_SWEEP_SWEEP_POINTS_HPP_

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/sweep/sweep_configs.hpp"
#include "ref/scene/scene.hpp"
#include "study/trade/trade.hpp"

namespace halfspace::cli {

struct SweepInput {
  std::vector<std::string> scenes;
  std::vector<std::string> vary;
  ConfigChoice choice{"middle", 0, false, true, {}};
  std::string size;             // "WxH"; empty: the base's; a *.tri has its own
  double time = 0;              // seconds into the animations
  std::string frames = "0:12";  // of a sweep of motion: A:B, at kFramesASecond, both included
  ref::SceneChoice shown;
  std::string area = "none";  // targets of rtl/synth/area.py, commas between them
  std::string out = "sweep";
};

struct SweepScene {
  std::string name;
  int width, height;
  std::string digest;  // of the file; empty if built in
  model::Subject subject;
  std::function<ref::Scene(double)> at = nullptr;  // of a sweep of motion: at a time
};

struct SweepPoint {
  bool is_area;
  std::size_t scene, config;  // into the lists of the sweep; an area has no scene
  Json what;                  // all that its result depends on, this machine apart
  std::string file;           // in the folder of the sweep
};

struct Sweep {
  SweepInput input;
  std::vector<Variation> variations;
  std::vector<SweepScene> scenes;
  std::vector<SweepConfig> configs;
  std::vector<std::string> targets;  // of the area
  bool motion = false;               // of frames between key frames
  std::pair<int, int> frames;        // of that
  ref::IdealLook finest;             // of the ideal pictures: no feature of a configuration is finer
  std::vector<SweepPoint> points;    // pictures first
};

// Throws ref::Error.
Sweep plan_sweep(const SweepInput& input);

// The result that stands in the point's file; null when there is none, or one of other numbers or another build.
Json stored_result(const Sweep& sweep, const SweepPoint& point);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SWEEP_SWEEP_POINTS_HPP_
