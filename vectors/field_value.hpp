// SPDX-License-Identifier: Apache-2.0
// A field of a packed word as a number: its bits, the sign extended; the value is that · 2^−fraction.
#ifndef HALFSPACE_VECTORS_FIELD_VALUE_HPP_
#define HALFSPACE_VECTORS_FIELD_VALUE_HPP_

#include "vectors/layout.hpp"

namespace halfspace::vectors {

inline std::int64_t field_value(const Word& word, const Field& field, int lane = 0) {
  const int lsb = field.lsb + lane * field.width, at = lsb / 64, shift = lsb % 64;
  std::uint64_t bits = word[at] >> shift;
  if (shift + field.width > 64) bits |= word[at + 1] << (64 - shift);
  const int spare = 64 - field.width;
  return field.is_signed ? std::int64_t(bits << spare) >> spare : std::int64_t(bits << spare >> spare);
}

}  // namespace halfspace::vectors

#endif  // HALFSPACE_VECTORS_FIELD_VALUE_HPP_
