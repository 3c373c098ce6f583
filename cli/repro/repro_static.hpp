// SPDX-License-Identifier: Apache-2.0
// halfspace repro E
#ifndef HALFSPACE_CLI_REPRO_REPRO_STATIC_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_STATIC_HPP_

#include <CLI/CLI.hpp>

namespace halfspace::cli {

void add_repro_static(CLI::App& repro);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_STATIC_HPP_
