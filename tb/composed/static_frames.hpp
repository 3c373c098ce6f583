// SPDX-License-Identifier: Apache-2.0
// The co-simulation of hs_static_frames: triangles and commands in, a memory of buffers beside it, every stream held
// against the vectors.
#ifndef HALFSPACE_TB_COMPOSED_STATIC_FRAMES_HPP_
#define HALFSPACE_TB_COMPOSED_STATIC_FRAMES_HPP_

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// Frames of equal registers follow each other at once. What is read comes from what was written, and not from the set.
Result run_static_frames(Model* model, const Vectors& vectors, const Options& options);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_COMPOSED_STATIC_FRAMES_HPP_
