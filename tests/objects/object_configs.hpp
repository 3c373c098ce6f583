// SPDX-License-Identifier: Apache-2.0
// Configurations with objects, as in configs/*.toml, compiled.
#ifndef HALFSPACE_TESTS_OBJECT_CONFIGS_HPP_
#define HALFSPACE_TESTS_OBJECT_CONFIGS_HPP_

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"

namespace halfspace {

// Configuration C with these bits of an object.
template <class C, int kBits>
constexpr Config with_objects(const char* name) {
  Config config = C::config();
  config.name = name;
  config.object_bits = kBits;
  return config;
}

struct ObjectsLow {
  static constexpr Config config() { return with_objects<Low, 4>("objects_low"); }
};
struct ObjectsMiddle {
  static constexpr Config config() { return with_objects<Middle, 16>("objects_middle"); }
};
struct ObjectsHigh {
  static constexpr Config config() { return with_objects<High, 16>("objects_high"); }
};

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_OBJECT_CONFIGS_HPP_
