// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/guard/guarded_read.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <new>

#include "ref/error.hpp"
#include "ref/scene/guard/document_stream.hpp"
#include "ref/scene/input_file.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define HALFSPACE_LIMITS_MEMORY 0  // the sanitizer reserves terabytes
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define HALFSPACE_LIMITS_MEMORY 0
#endif
#endif
#ifndef HALFSPACE_LIMITS_MEMORY
#define HALFSPACE_LIMITS_MEMORY 1
#endif

namespace halfspace::ref {
namespace {

rlim_t megabytes_of_this_process() {
  unsigned long pages = 0;
  if (std::FILE* const file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return rlim_t(pages) * rlim_t(sysconf(_SC_PAGESIZE)) >> 20;
}

void set_limit(decltype(RLIMIT_CPU) which, rlim_t soft, rlim_t hard) {
  const rlimit limit{soft, hard};
  setrlimit(which, &limit);  // a smaller one of the user's stays
}

void apply(const ReadLimits& limits) {
  set_limit(RLIMIT_CPU, limits.seconds, limits.seconds + 1);
  if (HALFSPACE_LIMITS_MEMORY) {
    const rlim_t bytes = (megabytes_of_this_process() + limits.megabytes) << 20;
    set_limit(RLIMIT_AS, bytes, bytes);
  }
  set_limit(RLIMIT_CORE, 0, 0);
}

std::string too_much_memory(const ReadLimits& limits) {
  return fmt::format("more than {} MB of memory", limits.megabytes);
}

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  throw Error(
      fmt::format("{}: cannot be read: it takes its reader {}; export it again, or in another format, and if "
                  "you know it to be good read it by --trust",
                  path, what));
}

// In the child: the answer, and the end of it. `_exit` runs nothing of the parent's.
[[noreturn]] void answer_and_end(int descriptor, const std::string& path, const ReadLimits& limits,
                                 const std::function<Document()>& read) {
  const int nowhere = ::open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  for (const int caught : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) signal(caught, SIG_DFL);
  apply(limits);
  Answer answer;
  try {
    answer.document = read();
  } catch (const Error& error) {
    answer.refusal = error.what();
  } catch (const std::bad_alloc&) {
    answer.refusal = path + ": cannot be read: it takes its reader " + too_much_memory(limits) + "; export it again";
  } catch (const std::exception& error) {
    answer.refusal =
        fmt::format("{}: cannot be read ({}); check the file, or export it again", path, one_line(error.what()));
  }
  try {
    write_answer(descriptor, answer);
  } catch (const std::exception&) {
    _exit(1);
  }
  _exit(0);
}

std::string end_of(int status, const ReadLimits& limits) {
  if (!WIFSIGNALED(status)) return fmt::format("to an end with status {}", WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  if (number == SIGXCPU || number == SIGKILL) return fmt::format("more than {} seconds", limits.seconds);
  return fmt::format("to a crash ({})", strsignal(number));
}

}  // namespace

ReadLimits limits_of(const std::string& path) {
  std::error_code ignored;
  const auto bytes = std::filesystem::file_size(path, ignored);
  const auto megabytes = ignored ? 0ul : static_cast<unsigned long>(bytes >> 20);
  return {15 + 2 * megabytes, 1400 + 50 * megabytes};
}

Document guarded_read(const std::string& path, const std::function<Document()>& read, const ReadLimits& limits) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw Error(fmt::format("{}: cannot be read ({})", path, std::strerror(errno)));
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) {
    const int reason = errno;
    close(ends[0]), close(ends[1]);
    throw Error(fmt::format("{}: no process can be started to read it ({}); free some memory, or read it by --trust",
                            path, std::strerror(reason)));
  }
  if (child == 0) answer_and_end(ends[1], path, limits, read);
  close(ends[1]);
  Answer answer;
  bool is_whole = true;
  try {
    answer = read_answer(ends[0]);
  } catch (const BrokenStream&) {
    is_whole = false;
  }
  close(ends[0]);
  if (!is_whole) kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
  if (!is_whole) fail(path, end_of(status, limits));
  if (!answer.refusal.empty()) throw Error(answer.refusal);
  return std::move(answer.document);
}

}  // namespace halfspace::ref
