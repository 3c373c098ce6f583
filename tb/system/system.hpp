// SPDX-License-Identifier: Apache-2.0
// The co-simulation of hs_system: the driver writes triangles and commands into a memory and registers through the
// bus, pictures come out as video, every stream inside is held against the vectors.
#ifndef HALFSPACE_TB_SYSTEM_SYSTEM_HPP_
#define HALFSPACE_TB_SYSTEM_SYSTEM_HPP_

#include "driver/halfspace.h"
#include "tb/harness/bench.hpp"
#include "tb/system/ports.hpp"

namespace halfspace::tb {

// Frames of equal registers are one command list, others lists one after the other. With a trouble of the options the
// first list is given up in that way, and then the set is drawn from its beginning.
Result run_system(Model* model, const Vectors& vectors, const Options& options, Picture* last);

// Cycles, waits, and bytes by client, of the last list.
std::string system_report(const hs_counters& counters, const Vectors& vectors);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_SYSTEM_SYSTEM_HPP_
