// SPDX-License-Identifier: Apache-2.0
#include "cli/sweep/sweep_configs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

constexpr int kMostValues = 1000, kMostBetween = 4;

int whole_number(const std::string& text, const std::string& option) {
  int value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size()) {
    throw ref::Error(
        fmt::format("--vary {}: '{}' is not a whole number: write it like subpixel_bits=4,6,8 or 4..8", option, text));
  }
  return value;
}

// The least fraction bits that planes of b bits are accepted with; 0: none are.
int least_fraction(const Config& c, int b) {
  for (int g = 1; g <= 40; ++g) {
    if (plane_error_ok(c, b, g)) return g;
  }
  return 0;
}

void set_value(Config& config, const std::string& key, const std::string& value) {
  if (key == kKeys) return;
  const model::ConfigField* field = model::find_field(key);
  if (field->is_number()) field->set(config, std::stoi(value));
  else model::set_choice(config, key, value);
}

// What is not there has no numbers; what a choice has brought has usual ones, where nothing else is said.
void settle(SweepConfig& config) {
  Config& c = config.numbers;
  const auto usual = [](int& number, bool is_there, int value) { number = is_there ? (number ? number : value) : 0; };
  if (!has_depth(c)) c.architecture = Architecture::kDelta;
  if (has_lighting(c) && c.normal_bits == 0 && !config.asked.count("gloss")) c.gloss = 16;
  usual(c.normal_bits, has_lighting(c), 13);
  usual(c.materials, has_lighting(c), 512);
  if (!has_lighting(c)) c.gloss = 0;
  const bool has_no_numbers = c.texels == 0 || c.textures == 0 || c.coordinate_bits == 0 || c.coordinate_fraction == 0;
  if (has_texture(c) && has_no_numbers && !config.asked.count("mapping")) c.mapping = TextureMapping::kPerspective;
  usual(c.texels, has_texture(c), 65536);
  usual(c.textures, has_texture(c), 32);
  if (!has_coordinates(c)) c.mapping = TextureMapping::kAffine;
  usual(c.coordinate_bits, has_coordinates(c), std::min(24, c.reciprocal_bits - 2));
  usual(c.depth_fraction, has_depth(c), least_fraction(c, c.depth_bits));
  usual(c.colour_fraction, has_colour_planes(c), least_fraction(c, colour_plane_bits(c)));
  usual(c.normal_fraction, is_phong(c), least_fraction(c, normal_plane_bits(c)));
  usual(c.coordinate_fraction, has_coordinates(c), least_fraction(c, c.coordinate_bits));
  if (!has_planes(c)) c.reciprocal_bits = 0;
}

// Merged with an equal one that is there already.
void add_config(std::vector<SweepConfig>& configs, SweepConfig config) {
  settle(config);
  for (SweepConfig& other : configs) {
    if (!model::same_numbers(other.numbers, config.numbers) || other.between != config.between) continue;
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
  config.asked[key] = value;
  if (key == kKeys) config.between = std::stoi(value);
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
  const model::ConfigField* field = model::find_field(variation.key);
  if (!field && variation.key != kKeys) {
    std::string names = kKeys;
    for (const auto& known : model::config_fields()) names += std::string(", ") + known.name;
    throw ref::Error(fmt::format("--vary {}: there is no number '{}' in a configuration: use one of {}", option,
                                 variation.key, names));
  }
  variation.is_choice = field && !field->is_number();
  const auto add = [&](const std::string& value) {
    auto& values = variation.values;
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  };
  std::stringstream list(equals == option.npos ? "" : option.substr(equals + 1));
  for (std::string word; std::getline(list, word, ',');) {
    const std::size_t dots = word.find("..");
    if (variation.is_choice) {
      const auto& words = field->words;
      const bool is_motion = variation.key == "shading" && word == "motion";
      if (is_motion || std::none_of(words.begin(), words.end(), [&](const char* known) { return word == known; })) {
        throw ref::Error(fmt::format("--vary {}: there is no {} '{}': use {}{}", option, variation.key, word,
                                     fmt::join(words.begin(), words.end() - (variation.key == "shading"), ", "),
                                     is_motion ? "; a base with motion stays one" : ""));
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
  if (variation.key == kKeys) {
    for (const std::string& value : variation.values) {
      if (std::stoi(value) >= 1 && std::stoi(value) <= kMostBetween) continue;
      throw ref::Error(
          fmt::format("--vary {}: 1 to {} frames are made for each key frame, not {}", option, kMostBetween, value));
    }
  }
  return variation;
}

Config base_numbers(const ConfigChoice& choice) {
  Config numbers = model::find_configuration(choice.config).config();
  if (choice.lanes) numbers.lanes = choice.lanes;
  return numbers;
}

namespace {

// What the configurations of a key have, and what brings it.
struct Needed {
  const char *what, *remedy;
};
Needed needed_by(const std::string& key) {
  const model::ConfigField* field = model::find_field(key);
  if (!field || field->part == Part::kMotion) return {"motion", ""};
  if (field->part == Part::kLighting) return {"lights", ", or vary lights too"};
  if (field->part == Part::kTexture) return {"texture", ", or vary texture too"};
  if (field->part == Part::kCoordinates) return {"texture or motion", ", or vary texture too"};
  return {"the unit that it is of", ", or vary that too"};
}

// A number that was varied and that none of them has means nothing.
void check_presence(const std::vector<SweepConfig>& configs, const Config& base, const Variation& variation) {
  const model::ConfigField* field = model::find_field(variation.key);
  const bool is_there = std::any_of(configs.begin(), configs.end(), [&](const SweepConfig& config) {
    const Config& c = config.numbers;
    if (!field) return has_motion(c);
    return has_part(field->part, c) && (!field->is_number() || field->get(c) != 0);
  });
  if (is_there || (variation.values.size() == 1 && variation.values[0] == "0")) return;
  const Needed needed = needed_by(variation.key);
  throw ref::Error(fmt::format("--vary {0}: configuration {1} has no {0}: name one by --config that has {2}{3}",
                               variation.key, base.name, needed.what, needed.remedy));
}

bool is_rich(const Config& c) { return has_lighting(c) || has_texture(c) || has_motion(c); }

}  // namespace

std::vector<SweepConfig> sweep_configs(const ConfigChoice& choice, const std::vector<Variation>& variations) {
  const model::Configuration configuration = model::find_configuration(choice.config);
  const SweepConfig base{configuration.name(), base_numbers(choice), "", ""};
  std::vector<SweepConfig> configs;
  if (choice.star) add_star(configs, base, variations);
  else add_grid(configs, base, variations, 0);
  Config named = base.numbers;
  named.name = configuration.name().c_str();
  for (const Variation& variation : variations) check_presence(configs, named, variation);
  const bool rich = std::any_of(configs.begin(), configs.end(), [](const auto& c) { return is_rich(c.numbers); });
  if (choice.named && !rich) add_named(configs, base, choice.frame);
  for (SweepConfig& config : configs)
    config.base = model::same_numbers(config.numbers, base.numbers) && config.between == base.between;
  return configs;
}

}  // namespace halfspace::cli
