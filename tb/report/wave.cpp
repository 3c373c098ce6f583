// SPDX-License-Identifier: Apache-2.0
#include "tb/report/wave.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

namespace halfspace::tb {
namespace {

// Runs a program with its own standard streams; its exit status.
int call(const std::vector<std::string>& words) {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) return 127;
  return WEXITSTATUS(status);
}

void write_window(const Options& options, const Result& result, const std::function<void()>& again) {
  const std::uint64_t at = std::uint64_t(result.first_cycle), around = std::uint64_t(options.around);
  const std::uint64_t first = at < around ? 0 : at - around;
  Model::wave = {options.wave, result.first_model, result.first_life, first, at + around + 1};
  Model::made = 0;
  Bench::lives = 0;
  again();
  std::printf("%s: cycles %llu to %llu, 10 ns each; the first failure is in cycle %llu, at %llu ns\n",
              options.wave.c_str(), static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(at + around), static_cast<unsigned long long>(at),
              static_cast<unsigned long long>(10 * at));
}

}  // namespace

void write_wave(int argc, char** argv, const Options& options, const Result& result,
                const std::function<void()>& again) {
  const TracedBuild build = traced_build();
  if (result.passed()) {
    std::printf(
        "%s: not written: nothing failed%s\n", options.wave.c_str(),
        build.is_this ? " in the model that writes waves, whose registers start at other values; try --seed" : "");
    return;
  }
  if (build.is_this) {
    write_window(options, result, again);
    return;
  }
  const std::string folder = options.wave + ".model";
  std::vector<std::string> command = build.command;
  command.insert(command.end(), {"--out", folder, "--log", folder + "/build.log"});
  if (call(command) != 0) {
    throw Error(options.wave + ": no model that writes waves could be built; " + folder + "/build.log says why");
  }
  std::vector<std::string> traced{folder + "/bench"};
  traced.insert(traced.end(), argv + 1, argv + argc);
  traced.push_back("--only-wave");
  if (call(traced) > 1) throw Error(options.wave + ": the model that writes waves could not run");
}

}  // namespace halfspace::tb
