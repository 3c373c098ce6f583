// SPDX-License-Identifier: Apache-2.0
// The records of buffers that know objects as plain numbers.
#ifndef HALFSPACE_MODEL_OBJECTS_OBJECT_RECORDS_HPP_
#define HALFSPACE_MODEL_OBJECTS_OBJECT_RECORDS_HPP_

#include <vector>

#include "hls/formats/object_records.hpp"
#include "model/objects/object_words.hpp"

namespace halfspace::model {

// Puts the pixels of a stamp into a frame, row by row, as far as they are inside.
template <class F>
void put_entry(const Entry<F>& in, int width, int height, std::vector<RawEntry>& frame) {
  for (int l = 0; l < F::kLanes; ++l) {
    const int x = int(raw(in.x)) * F::kLanesX + l % F::kLanesX, y = int(raw(in.y)) * F::kLanesY + l / F::kLanesX;
    if (x >= width || y >= height) continue;
    frame[std::size_t(y) * width + x] = {
        std::uint32_t(raw(in.depth[l])),
        std::uint32_t(raw(in.object[l])),
        {std::uint8_t(raw(in.r[l])), std::uint8_t(raw(in.g[l])), std::uint8_t(raw(in.b[l]))}};
  }
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_OBJECTS_OBJECT_RECORDS_HPP_
