// SPDX-License-Identifier: Apache-2.0
// Options of the papers that take models: A and B.
#ifndef HALFSPACE_CLI_REPRO_REPRO_OPTIONS_HPP_
#define HALFSPACE_CLI_REPRO_REPRO_OPTIONS_HPP_

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/common/output.hpp"
#include "cli/common/table.hpp"

namespace halfspace::cli {

struct ReproModelOptions {
  // Those of the paper that are free, or stand for them.
  std::vector<std::string> scenes = {"polyhedron", "two_tone", "teapot", "castle"};
  std::string out, json;
  TableOptions tables;
};

inline void add_model_options(CLI::App* paper, ReproModelOptions& options, const std::vector<std::string>& tables) {
  paper->add_option("SCENE", options.scenes, "built-in scenes or mesh files")->capture_default_str();
  add_output_folder(paper, "--out", options.out, "folder for the plots");
  add_json(paper, options.json);
  add_table_options(paper, options.tables, tables);
}

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_REPRO_REPRO_OPTIONS_HPP_
