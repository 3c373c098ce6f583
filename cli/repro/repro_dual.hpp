// SPDX-License-Identifier: Apache-2.0
// halfspace repro B
#ifndef HALFSPACE_CLI_REPRO_REPRO_DUAL_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_DUAL_HPP_

#include <CLI/CLI.hpp>

namespace halfspace::cli {

void add_repro_dual(CLI::App& repro);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_DUAL_HPP_
