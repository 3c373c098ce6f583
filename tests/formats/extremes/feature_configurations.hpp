// SPDX-License-Identifier: Apache-2.0
// The configurations of the tests that have something besides the base pipeline.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_FEATURE_CONFIGURATIONS_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_FEATURE_CONFIGURATIONS_HPP_

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"

namespace halfspace::tests {

inline bool has_feature(const Config& c) {
  return has_lighting(c) || has_texture(c) || has_motion(c) || has_objects(c);
}

// Those of which `is_of` holds. One that makes films is two of them at a time, and is left out.
inline std::vector<std::string> feature_configurations(bool (*is_of)(const Config&) = has_feature) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALFSPACE_SOURCE "/tests/configs")) {
    if (entry.path().extension() != ".toml") continue;
    const Config config = model::find_configuration(entry.path()).config();
    if (is_of(config) && !up_converts(config)) names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_FEATURE_CONFIGURATIONS_HPP_
