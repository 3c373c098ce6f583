// SPDX-License-Identifier: Apache-2.0
#include "model/pipeline/engine.hpp"

#include <algorithm>

namespace halfspace::model {

std::unique_ptr<Engine> make_engine_low(int lanes);
std::unique_ptr<Engine> make_engine_middle(int lanes);
std::unique_ptr<Engine> make_engine_high(int lanes);

std::vector<ref::RasterFormat> raster_formats() {
  std::vector<ref::RasterFormat> formats;
  for (const Configuration& c : named_configurations()) formats.push_back(raster_format(c));
  return formats;
}

ref::RasterFormat raster_format(const std::string& name_or_path) {
  return raster_format(find_configuration(name_or_path));
}

namespace {

bool is_named(const Configuration& configuration, const Configuration& named) {
  Config numbers = configuration.config();
  numbers.lanes = named.config().lanes;
  return configuration.name() == named.name() && same_numbers(numbers, named.config());
}

}  // namespace

bool is_compiled(const Configuration& configuration) {
  const auto& named = named_configurations();
  return std::any_of(named.begin(), named.end(), [&](const Configuration& c) { return is_named(configuration, c); });
}

std::unique_ptr<Engine> make_engine(const Configuration& configuration, int lanes) {
  const Config config = configuration.config();
  const auto& named = named_configurations();
  return is_named(configuration, named[0])   ? make_engine_low(lanes)
         : is_named(configuration, named[1]) ? make_engine_middle(lanes)
         : is_named(configuration, named[2]) ? make_engine_high(lanes)
                                             : make_runtime_engine(config, format_table(config), lanes);
}

std::unique_ptr<Engine> make_engine(const std::string& name_or_path, int lanes) {
  return make_engine(find_configuration(name_or_path), lanes);
}

}  // namespace halfspace::model
