// SPDX-License-Identifier: Apache-2.0
// The configurations of a sweep: all combinations of the values asked for, and the named ones.
#ifndef HALFSPACE_CLI_SWEEP_CONFIGS_HPP_
#define HALFSPACE_CLI_SWEEP_CONFIGS_HPP_

#include <map>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/common/scene_input.hpp"
#include "model/formats/configuration.hpp"

namespace halfspace::cli {

// Frames made for each key frame, of a sweep of motion: no number of a configuration, and varied like one.
constexpr const char* kKeys = "keys";

struct Variation {
  std::string key;  // a number or a choice of the configuration, or kKeys
  std::vector<std::string> values;
  bool is_choice = false;
};

struct SweepConfig {
  std::string name;
  Config numbers;       // its name means nothing
  std::string refused;  // why; empty if accepted
  std::string named;    // the named configuration with these numbers, lanes apart; empty if there is none
  bool base = false;
  std::map<std::string, std::string> asked = {};  // the values that it was varied to, by their keys
  int between = 1;                                // frames made for each key frame

  // Of an accepted one.
  model::Configuration configuration() const { return {name, numbers}; }
};

struct ConfigChoice {
  std::string config;  // the base
  int lanes = 0;       // of the base and of the named ones; 0: the base's own
  bool star = false;   // one key at a time, from the base
  bool named = true;   // the named configurations as well
  FrameSize
      frame;  // that is drawn, as far as it is known: what cannot hold it gets the base's frame, range and triangles
};

// "key=a,b,c" or "key=a..b"; of a choice its words. Throws ref::Error.
Variation parse_variation(const std::string& option);

// Each once, refused ones with their reason. Without a variation the base, and the named ones, which have neither
// lights nor texture nor motion and stand beside configurations without these alone. Numbers of what is not there are
// 0; a number of what a choice brings is a usual one. Throws ref::Error for a number that none of them has.
std::vector<SweepConfig> sweep_configs(const ConfigChoice&, const std::vector<Variation>&);

// The base's numbers.
Config base_numbers(const ConfigChoice&);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_SWEEP_CONFIGS_HPP_
