// SPDX-License-Identifier: Apache-2.0
// A field of a packed word as a number: its bits, the sign extended; the value is that · 2^−fraction.
#ifndef HALFSPACE_MODEL_FORMATS_FIELD_VALUE_HPP_
#define HALFSPACE_MODEL_FORMATS_FIELD_VALUE_HPP_

#include <algorithm>

#include "model/formats/layout.hpp"

namespace halfspace::model {

inline std::int64_t field_value(const Word& word, const Field& field, int lane = 0) {
  const int lsb = field.lsb + lane * field.width, at = lsb / 64, shift = lsb % 64;
  std::uint64_t bits = word[at] >> shift;
  if (shift + field.width > 64) bits |= word[at + 1] << (64 - shift);
  const int spare = 64 - field.width;
  return field.is_signed ? std::int64_t(bits << spare) >> spare : std::int64_t(bits << spare >> spare);
}

// The field of that name, which there is.
inline const Field& field_named(const Layout& layout, const char* name) {
  return *std::find_if(layout.fields.begin(), layout.fields.end(), [&](const Field& f) { return f.name == name; });
}

// The words, or the lanes of them, in which the field is not 0.
inline std::uint64_t count_set(const Layout& layout, const Word* words, std::size_t count, const char* name) {
  const Field& field = field_named(layout, name);
  std::uint64_t found = 0;
  for (std::size_t n = 0; n < count; ++n) {
    for (int lane = 0; lane < field.count; ++lane) found += field_value(words[n], field, lane) != 0;
  }
  return found;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_FIELD_VALUE_HPP_
