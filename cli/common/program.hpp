// SPDX-License-Identifier: Apache-2.0
// Programs that are called. What they say is kept: nothing of it reaches the screen but in a sentence of ours.
#ifndef HALFSPACE_CLI_COMMON_PROGRAM_HPP_
#define HALFSPACE_CLI_COMMON_PROGRAM_HPP_

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

namespace halfspace::cli {

struct ProgramEnd {
  int status = 0;      // of exit; 128 and more for a signal; 127: there is no such program
  std::string output;  // standard output, of run_program()
  std::string said;    // standard error
};

// Its first lines of words, as one line to put into a sentence.
std::string in_short(const std::string& said);

// Runs it to its end, with this input. Throws ref::Error when no process can be started.
ProgramEnd run_program(const std::vector<std::string>& words, const std::string& input = "");

// One that takes input piece by piece, and says all it says on standard error.
class FedProgram {
 public:
  explicit FedProgram(const std::vector<std::string>& words);
  ~FedProgram();
  FedProgram(const FedProgram&) = delete;
  FedProgram& operator=(const FedProgram&) = delete;

  // False when the program takes no more.
  bool feed(const void* bytes, std::size_t count);
  ProgramEnd end();

 private:
  pid_t child_ = -1;
  int input_ = -1, said_ = -1;
};

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_COMMON_PROGRAM_HPP_
