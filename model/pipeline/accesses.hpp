// SPDX-License-Identifier: Apache-2.0
// What a frame reads and writes of its memories, counted at the streams of the kernels.
#ifndef HALFSPACE_MODEL_PIPELINE_ACCESSES_HPP_
#define HALFSPACE_MODEL_PIPELINE_ACCESSES_HPP_

#include "model/pipeline/engine.hpp"
#include "model/pipeline/memories.hpp"
#include "ref/raster/architecture.hpp"

namespace halfspace::model {

// In entries; a buffer has one a pixel, a database one a triangle.
struct Accesses {
  // What was needed: a fragment reads the buffers and writes them if it passes; scan-out reads the pixels of the frame
  // and clears them; of TdbV and TdbS each different entry once a stamp.
  ref::BufferUses needed;
  // What the memories move: they are read by whole stamps, and the scan-out clears whole stamps; else only the lanes
  // that change are written. shade_phong reads TdbS for each pixel.
  ref::BufferUses words;
};
// Takes a rendering, with type γ two.
Accesses count_accesses(const Config&, Engine& engine, const ref::SnappedList& scene);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_PIPELINE_ACCESSES_HPP_
