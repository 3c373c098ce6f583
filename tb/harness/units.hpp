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

// Frame by frame: registers, what the unit finds in its memories, then its words; a frame ends when all its words were
// taken and seen, and a pause catches words that are too many. Runs of ztest_merge follow each other at once.
Result run_unit(Model* model, const Vectors& vectors, const Options& options);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_UNITS_HPP_
