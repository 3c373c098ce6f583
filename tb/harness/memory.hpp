// SPDX-License-Identifier: Apache-2.0
// A memory that a unit reads and writes through its ports: the bench's own, so that a unit is not tested with the RAM
// of the product. One read port, one write port by lanes, one or two banks; a read takes one cycle and keeps its word,
// and a read of the word that is being written gives the old one. Starts with random words.
#ifndef HALFSPACE_TB_HARNESS_MEMORY_HPP_
#define HALFSPACE_TB_HARNESS_MEMORY_HPP_

#include <cstdint>
#include <vector>

#include "tb/harness/model.hpp"

namespace halfspace::tb {

// The names of its ports. Null: there is no such port. No bank: there is one; no data to be written: that is 0.
struct MemoryPorts {
  const char* read_data;
  const char *read_enable, *read_bank, *read_address;
  const char *write_enable, *write_bank, *write_address, *write_data;
};

class Memory {
 public:
  // Whether the model has all the ports.
  static bool fits(const Model& model, const MemoryPorts& ports);
  Memory(const Model& model, const MemoryPorts& ports, std::uint64_t seed);

  // What the unit asks for, before the clock rises, and its answer, after it has.
  void sample();
  void answer();

  // For the bench, at once.
  void clear(int bank);
  // Of a word that consists of `lanes` parts those that `mask` has. `data`: one part for all, or, if `whole`, the word.
  void write(int bank, std::size_t address, std::uint64_t mask, int lanes, const std::uint32_t* data, bool whole);
  int bits() const { return bits_; }
  int banks() const { return int(banks_.size()); }

 private:
  std::uint32_t* word(int bank, std::size_t address) { return &banks_[std::size_t(bank)][address * parts_]; }
  int bank_of(const Port* bank) const { return bank ? *bank->bit() : 0; }

  const Port *read_data_, *read_enable_, *read_bank_, *read_address_;
  const Port *write_enable_, *write_bank_, *write_address_, *write_data_;
  int bits_;
  std::size_t parts_;
  std::vector<std::vector<std::uint32_t>> banks_;
  std::vector<std::uint32_t> read_;     // the word that the last read gave
  std::vector<std::uint32_t> written_;  // what is being written
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_MEMORY_HPP_
