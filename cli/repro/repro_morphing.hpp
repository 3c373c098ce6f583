// SPDX-License-Identifier: Apache-2.0
// halfspace repro D
#ifndef HALFSPACE_CLI_REPRO_REPRO_MORPHING_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_MORPHING_HPP_

#include <CLI/CLI.hpp>

namespace halfspace::cli {

void add_repro_morphing(CLI::App& repro);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_MORPHING_HPP_
