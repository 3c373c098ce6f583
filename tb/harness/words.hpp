// SPDX-License-Identifier: Apache-2.0
// Words of any one width, in the order of memory that Verilator's ports have too: 32-bit parts, least
// significant first, no bit set above the width.
#ifndef HALFSPACE_TB_HARNESS_WORDS_HPP_
#define HALFSPACE_TB_HARNESS_WORDS_HPP_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace halfspace::tb {

// `width` bits (64 at most) of a word, from bit `lsb` up.
inline std::uint64_t extract(const std::uint32_t* word, int lsb, int width) {
  std::uint64_t value = 0;
  for (int have = 0; have < width;) {
    const int bit = lsb + have;
    const int take = 32 - bit % 32;
    value |= std::uint64_t(word[bit / 32] >> (bit % 32)) << have;
    have += take;
  }
  return width == 64 ? value : value & ((std::uint64_t(1) << width) - 1);
}

// Bits [lsb, lsb + width) of `to` become those of `from` at `from_lsb`.
inline void copy_bits(std::uint32_t* to, int lsb, const std::uint32_t* from, int from_lsb, int width) {
  for (int done = 0; done < width;) {
    const int bit = (lsb + done) % 32;
    const int take = std::min(width - done, 32 - bit);
    const std::uint32_t mask = (take == 32 ? ~0u : (1u << take) - 1) << bit;
    std::uint32_t* const part = to + (lsb + done) / 32;
    *part = (*part & ~mask) | (std::uint32_t(extract(from, from_lsb + done, take)) << bit & mask);
    done += take;
  }
}

// A list of words of `bits` bits.
class Words {
 public:
  Words() = default;
  explicit Words(int bits) : bits_(bits), parts_(std::size_t(bits + 31) / 32) {}

  int bits() const { return bits_; }
  std::size_t parts() const { return parts_; }
  std::size_t size() const { return parts_ == 0 ? 0 : data_.size() / parts_; }
  void clear() { data_.clear(); }
  void reserve(std::size_t words) { data_.reserve(words * parts_); }

  const std::uint32_t* operator[](std::size_t n) const { return data_.data() + n * parts_; }
  // Adds a word of zeros and gives its place.
  std::uint32_t* append() {
    data_.resize(data_.size() + parts_);
    return data_.data() + data_.size() - parts_;
  }

 private:
  int bits_ = 0;
  std::size_t parts_ = 0;
  std::vector<std::uint32_t> data_;
};

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_HARNESS_WORDS_HPP_
