// SPDX-License-Identifier: Apache-2.0
// ztest_merge from its definition, for the tests.
#ifndef HALFSPACE_TESTS_OBJECTS_MERGE_MODEL_HPP_
#define HALFSPACE_TESTS_OBJECTS_MERGE_MODEL_HPP_

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "model/objects/merge.hpp"

namespace halfspace::tests {

// Columns and rows of a stamp.
inline std::array<int, 2> stamp_of(int lanes) {
  return lanes == 1   ? std::array<int, 2>{1, 1}
         : lanes == 2 ? std::array<int, 2>{2, 1}
         : lanes == 4 ? std::array<int, 2>{2, 2}
         : lanes == 8 ? std::array<int, 2>{4, 2}
                      : std::array<int, 2>{4, 4};
}

// What a run comes to, a pixel at a time; a key is one number here.
struct Expected {
  std::vector<model::RawEntry> merged;
  std::uint64_t count = 0, cycles = 0;
  ref::Box box;
};
inline Expected expected(const model::MergeInput& in, std::uint32_t full, int lanes) {
  const auto [w, h] = stamp_of(lanes);
  Expected out;
  out.merged = *in.stored;
  const int x0 = in.box.x0 / w * w, y0 = in.box.y0 / h * h;
  const int x1 = std::min((in.box.x1 + w - 1) / w * w, in.width), y1 = std::min((in.box.y1 + h - 1) / h * h, in.height);
  out.cycles = std::uint64_t(((x1 - x0 + w - 1) / w) * ((y1 - y0 + h - 1) / h)) + 1;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      const std::size_t at = std::size_t(y) * std::size_t(in.width) + std::size_t(x);
      model::RawEntry& pixel = out.merged[at];
      if (pixel.object != 0 && in.first <= pixel.object && pixel.object <= in.last) {
        ++out.count;
        out.box.add(
            ref::Box{x / w * w, y / h * h, std::min(x / w * w + w, in.width), std::min(y / h * h + h, in.height)});
        pixel = {full, 0, in.background};
      }
      const auto key = [](const model::RawEntry& e) { return std::uint64_t(e.depth) << 32 | e.object; };
      if (in.drawn && (pixel.object == 0 || key((*in.drawn)[at]) < key(pixel))) pixel = (*in.drawn)[at];
    }
  }
  return out;
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_OBJECTS_MERGE_MODEL_HPP_
