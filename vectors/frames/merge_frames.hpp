// SPDX-License-Identifier: Apache-2.0
// Runs for ztest_merge alone, each with what it is for: buffers that nothing has drawn.
#ifndef HALFSPACE_VECTORS_FRAMES_MERGE_FRAMES_HPP_
#define HALFSPACE_VECTORS_FRAMES_MERGE_FRAMES_HPP_

#include <string>
#include <vector>

#include "model/objects/merge.hpp"

namespace halfspace::model {

struct NamedMerge {
  std::string note;
  int width = 0, height = 0;
  ref::Box box;
  std::vector<RawEntry> stored, drawn;  // `drawn` is empty where nothing is merged
  bool sends = true;
  std::uint32_t first = 1, last = 0;
  std::array<std::uint8_t, 3> background{};

  MergeInput input() const {
    return {width, height, box, &stored, drawn.empty() ? nullptr : &drawn, sends, first, last, background};
  }
};

std::vector<NamedMerge> merge_frames(const Config& config, std::uint64_t seed);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_MERGE_FRAMES_HPP_
