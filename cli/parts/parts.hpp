// SPDX-License-Identifier: Apache-2.0
// Common FPGAs, and which of them hold a configuration.
#ifndef HALFSPACE_CLI_PARTS_PARTS_HPP_
#define HALFSPACE_CLI_PARTS_PARTS_HPP_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "model/formats/configuration.hpp"

namespace halfspace::cli {

// A family as the area tool names it: what its LUTs and blocks are.
struct Family {
  const char* target;
  const char* title;
  int block_kbit;
  const char* multiplier;
};

struct Fpga {
  const char* name;
  const Family* family;
  int luts, multipliers, blocks;
  const char* besides;  // memory that blocks are not
  const char* source;   // of the numbers
};
const std::vector<Fpga>& parts();
// Throws ref::Error with the names that there are.
const Fpga& find_part(const std::string& name);

// Block RAMs of the family for the memories of a frame, one lane: of each memory all of one shape, the fewest.
std::uint64_t frame_blocks(const model::Configuration&, const Family&);

// The pipeline with one lane, without the memories of the frame.
struct Circuit {
  int luts, multipliers, blocks;
};
// What docs/area.md has of low, middle and high.
std::optional<Circuit> known_circuit(const std::string& configuration, const Family&);
// The row `pipeline` of what measure_area says.
Circuit measured_circuit(const Json& area, const Family&);

// "inside": the part holds pipeline and memories; "outside": the pipeline, where the memories lie elsewhere; else what
// it has too little of. A circuit that is not known counts as none, and a ? stands behind.
std::string holds(const Fpga&, const std::optional<Circuit>&, std::uint64_t frame_blocks);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PARTS_PARTS_HPP_
