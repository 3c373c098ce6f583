// SPDX-License-Identifier: Apache-2.0
#include "cli/plots/gnuplot.hpp"

#include <fmt/format.h>

#include "cli/common/program.hpp"
#include "cli/common/shell.hpp"
#include "ref/error.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {

bool gnuplot_is_installed() { return is_installed("gnuplot"); }

std::string gnuplot_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("''") : std::string(1, c);
  return quoted + "'";
}

std::string drawn_by_gnuplot(const std::string& script, const std::string& name) {
  ProgramEnd end = run_program({"gnuplot"}, script);
  // A PNG ends with its chunk IEND, an empty one, and a checksum.
  const bool whole = end.output.size() > 12 && end.output.compare(end.output.size() - 8, 4, "IEND") == 0;
  if (end.status != 0 || !whole)
    throw ref::Error(fmt::format("{}: gnuplot did not draw it: {}", name, in_short(end.said)));
  return std::move(end.output);
}

void run_gnuplot(const std::string& script, const std::string& picture) {
  model::write_file(picture, drawn_by_gnuplot(script, picture));
}

}  // namespace halfspace::cli
