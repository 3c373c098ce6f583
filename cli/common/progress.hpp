// SPDX-License-Identifier: Apache-2.0
// Progress of work that takes longer than two seconds, on standard error.
#ifndef HALFSPACE_CLI_COMMON_PROGRESS_HPP_
#define HALFSPACE_CLI_COMMON_PROGRESS_HPP_

#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

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

// Work of which no part is known to be done, as another program does it: told by the time it takes.
class Waiting {
 public:
  explicit Waiting(std::string what) : what_(std::move(what)), teller_([this] { tell(); }) {}
  ~Waiting() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      over_ = true;
    }
    changed_.notify_all();
    teller_.join();
  }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  void tell() {
    const bool terminal = isatty(2) != 0;
    bool told = false;
    std::unique_lock<std::mutex> lock(mutex_);
    for (int seconds = 2; !changed_.wait_for(lock,
                                             std::chrono::seconds(told && !terminal ? 10
                                                                  : told            ? 1
                                                                                    : 2),
                                             [this] { return over_; });
         seconds += terminal ? 1 : 10) {
      std::fprintf(stderr, "%s%s: %d s%s", terminal ? "\r" : "", what_.c_str(), seconds, terminal ? "" : "\n");
      std::fflush(stderr);
      told = true;
    }
    if (told && terminal) std::fputc('\n', stderr);
  }

  std::string what_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread teller_;
};

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_PROGRESS_HPP_
