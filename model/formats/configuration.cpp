// SPDX-License-Identifier: Apache-2.0
#include "model/formats/configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <utility>

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "ref/error.hpp"

namespace halfspace::model {

Configuration::Configuration(std::string name, const Config& numbers) : name_(std::move(name)), numbers_(numbers) {
  const bool plain =
      std::all_of(name_.begin(), name_.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (name_.empty() || !plain) {
    throw ref::Error(fmt::format("configuration '{}': a name has letters, digits, '_' and '-' only", name_));
  }
  if (const Refusal reason = refusal(numbers_); reason != Refusal::kNone) {
    throw ref::Error(fmt::format("configuration {} is refused: {}", name_, refusal_text(reason)));
  }
}

Config Configuration::config() const {
  Config c = numbers_;
  c.name = name_.c_str();
  return c;
}

const std::vector<Configuration>& named_configurations() {
  static const std::vector<Configuration> named = {
      {"low", Low::config()}, {"middle", Middle::config()}, {"high", High::config()}};
  return named;
}

Configuration find_configuration(const std::string& name_or_path) {
  for (const Configuration& c : named_configurations()) {
    if (c.name() == name_or_path) return c;
  }
  const std::string ending = ".toml";
  if (name_or_path.size() <= ending.size() ||
      name_or_path.compare(name_or_path.size() - ending.size(), ending.size(), ending) != 0) {
    throw ref::Error(
        fmt::format("there is no configuration '{}': use low, middle, high or the path of a .toml file", name_or_path));
  }
  std::ifstream file(name_or_path);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    throw ref::Error(fmt::format("{}: cannot be read: check the path of the configuration", name_or_path));
  }
  return parse_configuration(text.str(), name_or_path);
}

ref::RasterFormat raster_format(const Configuration& configuration) {
  const Config c = configuration.config();
  return {configuration.name(), c.width,       c.height,
          c.triangles,          c.range_bits,  c.subpixel_bits,
          c.depth_bits,         c.colour_bits, c.shading == Shading::kFlat,
          ref::Cull(c.cull)};
}

}  // namespace halfspace::model
