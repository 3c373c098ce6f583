// SPDX-License-Identifier: Apache-2.0
// The area of a configuration, by rtl/synth/area.py.
#ifndef HALFSPACE_CLI_COMMON_AREA_HPP_
#define HALFSPACE_CLI_COMMON_AREA_HPP_

#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "model/formats/configuration.hpp"

namespace halfspace::cli {

// The names in "xilinx,ecp5"; none in "none". Throws ref::Error.
std::vector<std::string> area_targets(const std::string& text);

// The bytes of everything that decides about areas: the RTL and the tool.
std::string area_sources();

// With the lanes of the configuration: {"rows": …, "buffers": …, "yosys": …} of all units and the pipeline; its files,
// while it runs, are under `work`. Throws ref::Error.
Json measure_area(const model::Configuration&, const std::vector<std::string>& targets, const std::string& work);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_AREA_HPP_
