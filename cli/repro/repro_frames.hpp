// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_CLI_REPRO_REPRO_FRAMES_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_FRAMES_HPP_

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace halfspace::cli {

// The animated scenes that stand for the paper's.
std::vector<std::string> paper_animations();

// `halfspace repro C`: the table of frame-rate up-conversion.
void add_repro_frames(CLI::App* repro);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_FRAMES_HPP_
