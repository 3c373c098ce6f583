// SPDX-License-Identifier: Apache-2.0
// A pixel of a buffer that knows objects, in plain numbers.
#ifndef HALFSPACE_MODEL_OBJECTS_OBJECT_WORDS_HPP_
#define HALFSPACE_MODEL_OBJECTS_OBJECT_WORDS_HPP_

#include <array>
#include <cstdint>

namespace halfspace::model {

// Colours of colour_bits. Background: the largest depth, object 0.
struct RawEntry {
  std::uint32_t depth = 0, object = 0;
  std::array<std::uint8_t, 3> rgb{};

  bool operator==(const RawEntry& o) const { return depth == o.depth && object == o.object && rgb == o.rgb; }
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_OBJECTS_OBJECT_WORDS_HPP_
