// SPDX-License-Identifier: Apache-2.0
// The co-simulation of hs_pipeline: triangles in, every stream held against the vectors.
#ifndef HALFSPACE_TB_HARNESS_PIPELINE_HPP_
#define HALFSPACE_TB_HARNESS_PIPELINE_HPP_

#include <map>
#include <string>

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// What the RTL sent for the last frame, to make pictures from.
struct LastFrame {
  Words pixel;                           // of motion where there are no pixels
  std::map<std::string, Words> counted;  // by stream, those of count_rates; scan among them
};

// Frames of equal registers follow each other at once; before others the pipeline runs empty (busy_o).
Result run_pipeline(Model* model, const Vectors& vectors, const Options& options, LastFrame* last);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_PIPELINE_HPP_
