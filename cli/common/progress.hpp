// SPDX-License-Identifier: Apache-2.0
// Progress of work that takes longer than two seconds, on standard error.
#ifndef HALFSPACE_CLI_COMMON_PROGRESS_HPP_
#define HALFSPACE_CLI_COMMON_PROGRESS_HPP_

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>

namespace halfspace::cli {

// Silent for the first two seconds; on a terminal one line that is drawn again, elsewhere a line every ten seconds.
class Progress {
 public:
  explicit Progress(std::string what) : what_(std::move(what)) {}
  ~Progress() {
    if (told_ && terminal_) std::fputc('\n', stderr);
  }

  void tell(std::size_t done, std::size_t total) {
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    const double since = std::chrono::duration<double>(now - last_).count();
    if (elapsed < 2 || (told_ && since < (terminal_ ? 0.2 : 10))) return;
    std::fprintf(stderr, "%s%s: %zu of %zu, %.0f s%s", terminal_ ? "\r" : "", what_.c_str(), done, total, elapsed,
                 terminal_ ? "" : "\n");
    std::fflush(stderr);
    told_ = true;
    last_ = now;
  }

 private:
  std::string what_;
  bool terminal_ = isatty(2) != 0;
  bool told_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), last_ = start_;
};

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_PROGRESS_HPP_
