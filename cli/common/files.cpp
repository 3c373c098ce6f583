// SPDX-License-Identifier: Apache-2.0
#include "cli/common/files.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

namespace fs = std::filesystem;

fs::path program_folder() { return fs::read_symlink("/proc/self/exe").parent_path(); }

// Whether the program lies in the tree that it was built in: that tree may be moved or gone, and this one installed.
bool in_build_tree() {
  std::error_code absent;
  return fs::equivalent(program_folder(), HALFSPACE_BUILD_FOLDER, absent);
}

fs::path beside_program(const char* relative) { return (program_folder() / relative).lexically_normal(); }

std::string found(const fs::path& path, const char* remedy) {
  if (fs::exists(path)) return path.string();
  throw ref::Error(fmt::format("{} is not there: {}", path.string(), remedy));
}

}  // namespace

std::string data_folder() {
  if (const char* named = std::getenv("HALFSPACE_DATA")) return named;
  return in_build_tree() ? HALFSPACE_SOURCE_FOLDER : beside_program(HALFSPACE_DATA_FROM_PROGRAM).string();
}

std::string data_file(const std::string& name) {
  return found(fs::path(data_folder()) / name,
               "install halfspace with its component rtl, or set HALFSPACE_DATA to the folder of its sources");
}

std::string bench_library(const std::string& name) {
  const std::string file = "lib" + name + ".a";
  if (in_build_tree()) {
    return found(fs::path(HALFSPACE_TB_FOLDER) / file, "build the targets halfspace_tb and halfspace_verilated");
  }
  return found(beside_program(HALFSPACE_LIBRARIES_FROM_PROGRAM) / file,
               "build the targets halfspace_tb and halfspace_verilated, and install halfspace again");
}

}  // namespace halfspace::cli
