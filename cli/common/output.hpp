// SPDX-License-Identifier: Apache-2.0
// Options that name what is written. vectors/staging.hpp says how it is.
#ifndef HALFSPACE_CLI_COMMON_OUTPUT_HPP_
#define HALFSPACE_CLI_COMMON_OUTPUT_HPP_

#include <CLI/CLI.hpp>
#include <string>

#include "vectors/staging.hpp"

namespace halfspace::cli {

// Both are looked at before any work: whether there is a place for them. A file may be standard output: whatever else
// the command prints goes to standard error then.
inline CLI::Option* add_output_file(CLI::App* command, const std::string& names, std::string& file,
                                    const std::string& help) {
  return command->add_option(names, file, help)->each([](const std::string& path) {
    if (model::is_standard_output(path)) model::give_standard_output_to_files();
    model::StagedFile{path};
  });
}

inline CLI::Option* add_output_folder(CLI::App* command, const std::string& names, std::string& folder,
                                      const std::string& help) {
  return command->add_option(names, folder, help)->each(model::check_folder);
}

inline CLI::Option* add_json(CLI::App* command, std::string& file, const std::string& what = "the numbers") {
  return add_output_file(command, "--json", file, "file for " + what + "; - is standard output");
}

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_OUTPUT_HPP_
