// SPDX-License-Identifier: Apache-2.0
// The files that commands call besides the program: the bench and its builder, the area tool, the modules.
#ifndef HALFSPACE_CLI_COMMON_FILES_HPP_
#define HALFSPACE_CLI_COMMON_FILES_HPP_

#include <string>

namespace halfspace::cli {

// The folder that has rtl/ and tb/: that which HALFSPACE_DATA of the environment names; else, of a program in the tree
// that it was built in, the sources; else share/halfspace beside the program. It need not be there.
std::string data_folder();

// A file below it; throws a sentence if it is not there.
std::string data_file(const std::string& name);

// A library that benches are linked with, lib<name>.a, from the build tree or from lib/halfspace beside the program.
std::string bench_library(const std::string& name);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_FILES_HPP_
