// SPDX-License-Identifier: Apache-2.0
// The configurations of tests/configs by name, in whichever folder of it they are.
#ifndef HALFSPACE_TESTS_CONFIG_PATH_HPP_
#define HALFSPACE_TESTS_CONFIG_PATH_HPP_

#include <filesystem>
#include <stdexcept>
#include <string>

#include "model/formats/configuration.hpp"
#include "ref/error.hpp"

namespace halfspace {

// HALFSPACE_SOURCE is the folder of the sources.
inline std::string config_path(const std::string& name) {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALFSPACE_SOURCE "/tests/configs")) {
    if (entry.path().filename() == name + ".toml") return entry.path().string();
  }
  throw std::runtime_error("tests/configs: there is no " + name + ".toml");
}

// One that a test has compiled, as the model takes it.
inline model::Configuration configuration_of(const Config& config) { return model::Configuration(config.name, config); }

// Why it is refused; "accepted" if it is not.
inline std::string refusal_of(const Config& config) {
  try {
    configuration_of(config);
  } catch (const ref::Error& e) {
    return e.what();
  }
  return "accepted";
}
// And once it is changed so.
template <class Change>
std::string refusal_of(Config config, Change change) {
  change(config);
  return refusal_of(config);
}

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_CONFIG_PATH_HPP_
