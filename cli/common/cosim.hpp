// SPDX-License-Identifier: Apache-2.0
// The RTL of a configuration on frames, from within the program: its package is printed, its bench is built by
// tb/model.py, and the streams of the kernels are held against it.
#ifndef HALFSPACE_CLI_COMMON_COSIM_HPP_
#define HALFSPACE_CLI_COMMON_COSIM_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "vectors/vector_set.hpp"

namespace halfspace::cli {

struct Cosimulation {
  std::uint64_t words = 0, mismatches = 0, cycles = 0;  // cycles: of the last frame in steady state
};

// Works in `folder`, which stays. Throws ref::Error when the bench cannot be built or run.
Cosimulation cosimulate(const std::string& folder, const std::string& scene, const model::Configuration& configuration,
                        int lanes, const std::vector<model::NamedFrame>& frames);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_COSIM_HPP_
