// SPDX-License-Identifier: Apache-2.0
// The command line of the bench and of the co-simulation.
#ifndef HALFSPACE_TB_HARNESS_OPTIONS_HPP_
#define HALFSPACE_TB_HARNESS_OPTIONS_HPP_

#include <cstdint>
#include <string>

namespace halfspace::tb {

struct Options {
  std::string vectors;         // folder of the vector set
  std::uint64_t seed = 1;      // of the stalls and of memories without a reset
  int stall = 0;               // percent of the cycles
  std::uint64_t hang = 20000;  // cycles without a word that count as a hang
  int outside_latency = -1;    // of memory outside, in cycles; < 0: random
  std::uint32_t mutant = 0;    // of a model that has some (tb/mutation.py)
  std::string json;
  std::string wave;        // the waveform around the first failure goes here
  int around = 200;        // cycles before it and behind it
  bool only_wave = false;  // the report was given
  // hs_pipeline only:
  int frames = 2;          // times that the last frame is drawn
  int setup_interval = 0;  // cycles a triangle; 0: that of the package
  std::string dump, dump_index;
  std::string pictures;  // a folder
  // hs_system only:
  int latency = -1;     // of the memory, in cycles; < 0: 40
  bool refresh = true;  // it pauses now and then
  // 0: not. The first list is stopped, or all is reset, after so many cycles; or this burst is answered with an error.
  std::uint64_t stop_at = 0, reset_at = 0, break_read = 0, break_write = 0;
};

// Exits by itself for --help (0) and for a wrong command line (2).
Options parse_options(int argc, char** argv, const std::string& top);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_OPTIONS_HPP_
