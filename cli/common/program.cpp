// SPDX-License-Identifier: Apache-2.0
#include "cli/common/program.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <sstream>

#include "ref/error.hpp"

namespace halfspace::cli {
namespace {

[[noreturn]] void no_program(const std::string& name) {
  throw ref::Error(name + " cannot be started: free some memory, or stop other programs");
}

bool put(int file, const char* bytes, std::size_t count) {
  while (count != 0) {
    const ssize_t done = write(file, bytes, count);
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return false;
    bytes += done, count -= std::size_t(done);
  }
  return true;
}

std::string rest_of(int file) {
  std::string text;
  char buffer[1 << 14];
  for (;;) {
    const ssize_t count = read(file, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, std::size_t(count));
  }
}

std::string all_of(int file) {
  lseek(file, 0, SEEK_SET);
  return rest_of(file);
}

pid_t start(const std::vector<std::string>& words, int in, int out, int said) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child;
  signal(SIGPIPE, SIG_DFL);
  dup2(in, 0), dup2(out, 1), dup2(said, 2);
  execvp(argv[0], argv.data());
  _exit(127);
}

int status_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) return 127;
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

std::string in_short(const std::string& said) {
  std::istringstream lines(said);
  std::string text;
  int count = 0;
  for (std::string line; count < 3 && std::getline(lines, line);) {
    if (line.rfind('[', 0) == 0 && line.find("] ") != std::string::npos) line.erase(0, line.find("] ") + 2);
    const std::size_t first = line.find_first_not_of(" \t\r^"), last = line.find_last_not_of(" \t\r.");
    if (first == std::string::npos || last < first) continue;
    text += (count++ ? "; " : "") + line.substr(first, last + 1 - first);
  }
  return text.empty() ? "it says nothing" : text.substr(0, 400);
}

ProgramEnd run_program(const std::vector<std::string>& words, const std::string& input) {
  const int in = memfd_create("input", MFD_CLOEXEC), said = memfd_create("said", MFD_CLOEXEC);
  int out[2] = {-1, -1};
  const bool ready = in >= 0 && said >= 0 && put(in, input.data(), input.size()) && pipe2(out, O_CLOEXEC) == 0;
  if (ready) lseek(in, 0, SEEK_SET);
  const pid_t child = ready ? start(words, in, out[1], said) : -1;
  close(in), close(out[1]);
  ProgramEnd end;
  if (child > 0) {
    end.output = rest_of(out[0]);
    end.status = status_of(child);
    end.said = all_of(said);
  }
  close(out[0]), close(said);
  if (child < 0) no_program(words[0]);
  return end;
}

FedProgram::FedProgram(const std::vector<std::string>& words) : said_(memfd_create("said", MFD_CLOEXEC)) {
  // One that ends early must not end this one with it.
  std::signal(SIGPIPE, SIG_IGN);
  int in[2] = {-1, -1};
  if (said_ >= 0 && pipe2(in, O_CLOEXEC) == 0) child_ = start(words, in[0], said_, said_);
  close(in[0]);
  input_ = in[1];
  if (child_ < 0) no_program(words[0]);
}

FedProgram::~FedProgram() {
  if (child_ > 0) end();
}

bool FedProgram::feed(const void* bytes, std::size_t count) {
  return put(input_, static_cast<const char*>(bytes), count);
}

ProgramEnd FedProgram::end() {
  close(input_);
  ProgramEnd end;
  end.status = status_of(child_);
  child_ = -1;
  end.said = all_of(said_);
  close(said_);
  return end;
}

}  // namespace halfspace::cli
