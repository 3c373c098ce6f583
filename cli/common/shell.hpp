// SPDX-License-Identifier: Apache-2.0
// Programs that are called by the shell.
#ifndef HALFSPACE_CLI_COMMON_SHELL_HPP_
#define HALFSPACE_CLI_COMMON_SHELL_HPP_

#include <cstdlib>
#include <string>

namespace halfspace::cli {

// In single quotes.
inline std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

inline bool is_installed(const std::string& program) {
  return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_SHELL_HPP_
