// SPDX-License-Identifier: Apache-2.0
// halfspace fit --part: the most accurate configuration, of those that the search finds, that an FPGA holds.
#ifndef HALFSPACE_CLI_PARTS_FIT_PART_HPP_
#define HALFSPACE_CLI_PARTS_FIT_PART_HPP_

#include <functional>
#include <string>

#include "cli/parts/parts.hpp"
#include "study/fit/fit.hpp"

namespace halfspace::cli {

// Whether the memories of a frame lie inside the part; of one with single-port RAMs I-buffer and Z-buffer lie in these,
// as rtl/board/ has them. Else what is too little.
std::string lacks_memory(const Fpga&, const model::Configuration&);

// What the part lacks for the pipeline, or "": of a part that a board of rtl/board/ has, by place and route with the
// scene in it; else by Yosys. Minutes. Files, while it runs, are under `work`.
std::string lacks_circuit(const Fpga&, const model::Configuration&, const std::string& scene, const std::string& work);

// Searches for the goal, and for ever lower ratios, until the part holds what is found, and says what happens. With
// `circuit` that is looked at besides the memories. Throws ref::Error if nothing above 15 dB fits.
model::Fit fit_in_part(const Fpga&, const std::string& scene, model::FitGoal goal, bool circuit,
                       const std::string& work, const std::function<model::Fit(const model::FitGoal&)>& search);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PARTS_FIT_PART_HPP_
