// SPDX-License-Identifier: Apache-2.0
// The bench of a unit alone, which is the top of the model. Its streams are found by its ports: what has
// <stream>_valid_i is sent to it, what has <stream>_valid_o is held against the set.
#ifndef HALFSPACE_TB_HARNESS_UNITS_HPP_
#define HALFSPACE_TB_HARNESS_UNITS_HPP_

#include <string>
#include <vector>

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// Streams that the bench drives, compares or explains with.
std::vector<std::string> unit_streams(const Model& model, const Vectors& vectors);

// Frame by frame: registers, what the unit finds in its memories, then its words. Some frames follow the one before at
// once, if the registers are the same, or are sent twice; the others end when all words were taken and seen, and a
// pause catches words that are too many. Runs of ztest_merge follow each other at once. Without stalls each frame is
// alone. Before that, a frame with all registers at 0 before the reset, one with all at 1, and one that a reset ends.
// Of a film a pass in which the unit sends nothing is left out.
Result run_unit(const Vectors& vectors, const Options& options);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_UNITS_HPP_
