// SPDX-License-Identifier: Apache-2.0
// Frames for index_pool: its window, and indices that run out.
#ifndef HALFSPACE_VECTORS_FRAMES_INDEX_FRAMES_HPP_
#define HALFSPACE_VECTORS_FRAMES_INDEX_FRAMES_HPP_

#include <vector>

#include "model/pipeline/named_frame.hpp"

namespace halfspace::model {

// Of a configuration with an index_window. Frames with more visible triangles than indices are among them, where the
// largest frame has room for so many side by side.
std::vector<NamedFrame> index_frames(const ref::RasterFormat& format, const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_INDEX_FRAMES_HPP_
