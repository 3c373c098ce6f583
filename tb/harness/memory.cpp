// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/memory.hpp"

#include <algorithm>
#include <cstring>

#include "tb/harness/stall.hpp"
#include "tb/harness/words.hpp"

namespace halfspace::tb {
namespace {

const Port* find(const Model& model, const char* name) { return name ? &model.need(name) : nullptr; }

std::uint64_t value_of(const Port& port) {
  std::uint64_t value = 0;
  std::memcpy(&value, port.data, std::size_t(std::min(port.bytes, 8)));
  return value;
}

// No bit is set above the width, as Verilator's ports have it.
void fill_random(std::vector<std::uint32_t>* words, std::size_t parts, int bits, Random* random) {
  const std::uint32_t top = bits % 32 ? (1u << bits % 32) - 1 : ~0u;
  for (std::size_t i = 0; i < words->size(); ++i) (*words)[i] = random->next() & ((i + 1) % parts == 0 ? top : ~0u);
}

}  // namespace

bool Memory::fits(const Model& model, const MemoryPorts& ports) {
  for (const char* const name : {ports.read_data, ports.read_enable, ports.read_bank, ports.read_address,
                                 ports.write_enable, ports.write_bank, ports.write_address, ports.write_data}) {
    if (name && !model.find(name)) return false;
  }
  return true;
}

Memory::Memory(const Model& model, const MemoryPorts& ports, std::uint64_t seed)
    : read_data_(find(model, ports.read_data)),
      read_enable_(find(model, ports.read_enable)),
      read_bank_(find(model, ports.read_bank)),
      read_address_(find(model, ports.read_address)),
      write_enable_(find(model, ports.write_enable)),
      write_bank_(find(model, ports.write_bank)),
      write_address_(find(model, ports.write_address)),
      write_data_(find(model, ports.write_data)),
      bits_(read_data_->bits),
      parts_(std::size_t(bits_ + 31) / 32),
      banks_(read_bank_ ? 2 : 1),
      read_(parts_),
      written_(parts_ + 1) {
  Random random(seed);
  for (auto& bank : banks_) {
    bank.resize(parts_ << read_address_->bits);
    fill_random(&bank, parts_, bits_, &random);
  }
  fill_random(&read_, parts_, bits_, &random);
  answer();
}

void Memory::sample() {
  if (*read_enable_->bit()) std::memcpy(read_.data(), word(bank_of(read_bank_), value_of(*read_address_)), parts_ * 4);
  if (!write_enable_) return;
  const std::uint64_t mask = value_of(*write_enable_);
  if (mask == 0) return;
  if (write_data_) std::memcpy(written_.data(), write_data_->data, std::size_t(write_data_->bytes));
  const bool whole = write_data_ && write_data_->bits == bits_;
  write(bank_of(write_bank_), value_of(*write_address_), mask, write_enable_->bits, written_.data(), whole);
}

void Memory::answer() {
  std::memcpy(read_data_->data, read_.data(), std::size_t(std::min<std::size_t>(read_data_->bytes, parts_ * 4)));
}

void Memory::clear(int bank) { std::fill(banks_[std::size_t(bank)].begin(), banks_[std::size_t(bank)].end(), 0); }

void Memory::write(int bank, std::size_t address, std::uint64_t mask, int lanes, const std::uint32_t* data,
                   bool whole) {
  const int part = bits_ / lanes;
  address &= (std::size_t(1) << read_address_->bits) - 1;
  for (int lane = 0; lane < lanes; ++lane) {
    if ((mask >> lane & 1) == 0) continue;
    copy_bits(word(bank, address), lane * part, data, whole ? lane * part : 0, part);
  }
}

}  // namespace halfspace::tb
