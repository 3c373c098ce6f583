// SPDX-License-Identifier: Apache-2.0
// The benches of hs_units: each unit alone.
#ifndef HALFSPACE_TB_HARNESS_UNITS_HPP_
#define HALFSPACE_TB_HARNESS_UNITS_HPP_

#include <string>
#include <vector>

#include "tb/harness/bench.hpp"

namespace halfspace::tb {

// The names of the units that a model has, in the order of the data.
std::vector<std::string> unit_names(const Model&, const Vectors&);

// Streams that the bench of `unit` drives, compares or explains with.
std::vector<std::string> unit_streams(const std::string& unit, const Vectors&);

// Frame by frame: registers, what the unit finds in its buffers, then its words; a frame ends when all its words were
// taken and seen, and a pause catches words that are too many. Frames of a unit without such registers follow each
// other at once.
Result run_unit(const std::string& unit, Model* model, const Vectors& vectors, const Options& options);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_UNITS_HPP_
