// SPDX-License-Identifier: Apache-2.0
#include "cli/plots/gnuplot.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "cli/common/shell.hpp"
#include "ref/error.hpp"

namespace halfspace::cli {

bool gnuplot_is_installed() { return is_installed("gnuplot"); }

std::string gnuplot_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

void run_gnuplot(const std::string& script, const std::string& picture) {
  FILE* const pipe = popen("gnuplot", "w");
  if (!pipe) throw ref::Error("gnuplot cannot be started: free some memory");
  const bool sent = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
  std::error_code error;
  if (pclose(pipe) != 0 || !sent || std::filesystem::file_size(picture, error) == 0 || error) {
    throw ref::Error(fmt::format("{}: gnuplot did not draw it: its own message says why", picture));
  }
}

}  // namespace halfspace::cli
