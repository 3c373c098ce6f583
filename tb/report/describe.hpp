// SPDX-License-Identifier: Apache-2.0
// Words in a person's terms: stream, word, frame, triangle, pixel, field, expected, got.
#ifndef HALFSPACE_TB_REPORT_DESCRIBE_HPP_
#define HALFSPACE_TB_REPORT_DESCRIBE_HPP_

#include <cstddef>
#include <cstdint>
#include <string>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

// Names a word of a stream. `note` says what else is special about it, or is empty.
struct WordPlace {
  const Vectors* vectors;
  const Stream* stream;
  std::size_t word;   // of the stream's file, from 0
  std::size_t frame;  // from 0
  std::string note;
  std::int64_t cycle = -1;  // in which it came; < 0: not known
};

// "stamp word 812 (raster_pineda → ztest_index), frame 0, triangle 57, pixel (317, 42), cycle 4033: depth[2] expected
// 0x3fa201 got 0x3fa200". The triangle and the pixel are those of the expected word; the fields that differ are listed.
std::string describe_mismatch(const WordPlace& place, const std::uint32_t* got);

// All fields of a word: "last 0, index 0x39, …".
std::string describe_fields(const Stream& stream, const std::uint32_t* word);

// "stamp (raster_pineda → ztest_index)"
std::string describe_stream(const Stream& stream);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_DESCRIBE_HPP_
