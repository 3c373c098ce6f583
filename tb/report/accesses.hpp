// SPDX-License-Identifier: Apache-2.0
// What a frame read and wrote of its memories, counted in the words that the RTL sent.
#ifndef HALFSPACE_TB_REPORT_ACCESSES_HPP_
#define HALFSPACE_TB_REPORT_ACCESSES_HPP_

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

struct Accesses {
  std::string buffer;
  std::uint64_t entry_bits = 0;
  std::uint64_t read = 0, written = 0;            // entries that were needed
  std::uint64_t word_read = 0, word_written = 0;  // entries in the words that the memory moved
  std::uint64_t memory_bits = 0;                  // of all its banks

  static std::uint64_t bytes(std::uint64_t entries, std::uint64_t bits) { return (entries * bits + 7) / 8; }
};

// The frame and the triangles that the model is built for.
struct Largest {
  std::uint64_t width, height, triangles;
};
// Of each buffer that the set's configuration has; of a set that lacks one of the streams that tell them, nothing.
std::vector<Accesses> count_accesses(const Vectors& vectors, const std::map<std::string, Words>& received,
                                     const Largest& largest);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_ACCESSES_HPP_
