// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_configs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

constexpr const char* kShading = "shading";
constexpr int kMostValues = 1000;

int whole_number(const std::string& text, const std::string& option) {
  int value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) {
    throw ref::Error(
        fmt::format("--vary {}: '{}' is not a whole number: write it like subpixel_bits=4,6,8 or 4..8", option, text));
  }
  return value;
}

// The numbers that can be varied: those that every configuration has, and the bits of objects.
std::vector<model::ConfigField> varied_fields() {
  std::vector<model::ConfigField> fields = model::numbers_of(Part::kBase);
  for (const auto& field : model::numbers_of(Part::kObjects)) fields.push_back(field);
  return fields;
}

void set_value(Config& config, const std::string& key, const std::string& value) {
  if (key == kShading) config.shading = value == "flat" ? Shading::kFlat : Shading::kGouraud;
  for (const auto& field : varied_fields()) {
    if (field.name == key) field.set(config, std::stoi(value));
  }
}

// What is not there has no numbers.
void drop_idle(Config& config) {
  if (!has_depth(config)) config.depth_fraction = 0;
  if (!is_gouraud(config)) config.colour_fraction = 0;
  if (!has_planes(config)) config.reciprocal_bits = 0;
}

// Merged with an equal one that is there already.
void add_config(std::vector<SweepConfig>& configs, SweepConfig config) {
  drop_idle(config.numbers);
  for (SweepConfig& other : configs) {
    if (!model::same_numbers(other.numbers, config.numbers)) continue;
    if (other.named.empty()) other.named = config.named;
    return;
  }
  try {
    config.configuration();
  } catch (const ref::Error& error) {
    config.refused = error.what();
  }
  configs.push_back(std::move(config));
}

void vary(SweepConfig& config, const std::string& key, const std::string& value) {
  set_value(config.numbers, key, value);
  config.name += fmt::format("-{}{}", key, value);
}

// All combinations of the values of variation `k` and of those behind it.
void add_grid(std::vector<SweepConfig>& configs, const SweepConfig& config, const std::vector<Variation>& variations,
              std::size_t k) {
  if (k == variations.size()) return add_config(configs, config);
  for (const std::string& value : variations[k].values) {
    SweepConfig next = config;
    vary(next, variations[k].key, value);
    add_grid(configs, next, variations, k + 1);
  }
}

void add_star(std::vector<SweepConfig>& configs, const SweepConfig& base, const std::vector<Variation>& variations) {
  add_config(configs, base);
  for (const Variation& variation : variations) {
    for (const std::string& value : variation.values) {
      SweepConfig config = base;
      vary(config, variation.key, value);
      add_config(configs, config);
    }
  }
}

void add_named(std::vector<SweepConfig>& configs, const SweepConfig& base, const FrameSize& frame) {
  for (const model::Configuration& named : model::named_configurations()) {
    SweepConfig config{named.name(), named.config(), "", named.name()};
    config.numbers.lanes = base.numbers.lanes;
    if (frame.width > config.numbers.width || frame.height > config.numbers.height) {
      for (const auto field : {&Config::width, &Config::height, &Config::triangles, &Config::range_bits}) {
        config.numbers.*field = base.numbers.*field;
      }
      config.name += "-in-" + base.name;
      config.named = config.name;
    }
    add_config(configs, config);
  }
}

}  // namespace

Variation parse_variation(const std::string& option) {
  const std::size_t equals = option.find('=');
  Variation variation{option.substr(0, equals), {}};
  const auto fields = varied_fields();
  const auto is_key = [&](const auto& field) { return field.name == variation.key; };
  if (variation.key != kShading && std::none_of(fields.begin(), fields.end(), is_key)) {
    std::string names = kShading;
    for (const auto& field : fields) names += std::string(", ") + field.name;
    throw ref::Error(fmt::format("--vary {}: there is no number '{}' in a configuration: use one of {}", option,
                                 variation.key, names));
  }
  const auto add = [&](const std::string& value) {
    auto& values = variation.values;
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  };
  std::stringstream list(equals == option.npos ? "" : option.substr(equals + 1));
  for (std::string word; std::getline(list, word, ',');) {
    const std::size_t dots = word.find("..");
    if (variation.key == kShading) {
      if (word != "gouraud" && word != "flat") {
        throw ref::Error(fmt::format("--vary {}: there is no shading '{}': use gouraud or flat", option, word));
      }
      add(word);
    } else if (dots == word.npos) {
      add(std::to_string(whole_number(word, option)));
    } else {
      const int first = whole_number(word.substr(0, dots), option), last = whole_number(word.substr(dots + 2), option);
      if (std::int64_t(last) - first >= kMostValues) {
        throw ref::Error(fmt::format("--vary {}: more than {} values: name fewer", option, kMostValues));
      }
      for (int n = first; n <= last; ++n) add(std::to_string(n));
    }
  }
  if (variation.values.empty()) {
    throw ref::Error(fmt::format("--vary {}: there are no values: write it like subpixel_bits=4,6,8 or 4..8", option));
  }
  return variation;
}

Config base_numbers(const ConfigChoice& choice) {
  Config numbers = model::find_configuration(choice.config).config();
  if (choice.lanes) numbers.lanes = choice.lanes;
  return numbers;
}

std::vector<SweepConfig> sweep_configs(const ConfigChoice& choice, const std::vector<Variation>& variations) {
  const SweepConfig base{model::find_configuration(choice.config).name(), base_numbers(choice), "", ""};
  std::vector<SweepConfig> configs;
  if (choice.star) add_star(configs, base, variations);
  else add_grid(configs, base, variations, 0);
  if (choice.named) add_named(configs, base, choice.frame);
  for (SweepConfig& config : configs) config.base = model::same_numbers(config.numbers, base.numbers);
  return configs;
}

}  // namespace halfspace::cli
