// SPDX-License-Identifier: Apache-2.0
// halfspace repro A
#ifndef HALFSPACE_CLI_REPRO_REPRO_INDEX_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_INDEX_HPP_

#include <CLI/CLI.hpp>

namespace halfspace::cli {

void add_repro_index(CLI::App& repro);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_INDEX_HPP_
