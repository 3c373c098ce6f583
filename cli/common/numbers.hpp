// SPDX-License-Identifier: Apache-2.0
// Numbers of options, and what is said of others.
#ifndef HALFSPACE_CLI_COMMON_NUMBERS_HPP_
#define HALFSPACE_CLI_COMMON_NUMBERS_HPP_

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace halfspace::cli {

inline CLI::Validator above_zero() {
  return {[](std::string& text) {
            double value = 0;
            return CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value > 0
                       ? ""
                       : fmt::format("'{}' is not a number above 0", text);
          },
          "above 0"};
}

inline CLI::Validator finite() {
  return {[](std::string& text) {
            double value = 0;
            return CLI::detail::lexical_cast(text, value) && std::isfinite(value)
                       ? ""
                       : fmt::format("'{}' is not a finite number", text);
          },
          ""};
}

inline CLI::Validator zero_or_more() {
  return {[](std::string& text) {
            double value = 0;
            return CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0
                       ? ""
                       : fmt::format("'{}' is not a number of 0 or more", text);
          },
          "0 or more"};
}

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_NUMBERS_HPP_
