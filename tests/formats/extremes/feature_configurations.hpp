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

// Extremes have triangles that are seen from either side, and a triangle's place in the list is its index.
inline bool draws_all(const Config& c) { return c.cull == Cull::kNone && c.index_window == 0; }
inline Config that_draws_all(Config c) {
  c.cull = Cull::kNone, c.index_window = 0;
  return c;
}

// Those of which `is_of` holds and that draw all. One that makes films is two of them at a time, and is left out.
inline std::vector<std::string> feature_configurations(bool (*is_of)(const Config&) = has_feature) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALFSPACE_SOURCE "/tests/configs")) {
    if (entry.path().extension() != ".toml") continue;
    const Config config = model::find_configuration(entry.path()).config();
    if (is_of(config) && draws_all(config) && !up_converts(config)) names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_FEATURE_CONFIGURATIONS_HPP_
