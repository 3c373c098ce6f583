// SPDX-License-Identifier: Apache-2.0
// Orders of events that neither corner cases nor random frames bring: what a fault in a bank, a forward or a count of
// frames needs to be seen. Each frame says which.
#ifndef HALFSPACE_VECTORS_FRAMES_RARE_FRAMES_HPP_
#define HALFSPACE_VECTORS_FRAMES_RARE_FRAMES_HPP_

#include <vector>

#include "model/pipeline/named_frame.hpp"

namespace halfspace::model {

std::vector<NamedFrame> rare_frames(const ref::RasterFormat& format, const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_RARE_FRAMES_HPP_
