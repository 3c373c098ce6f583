// SPDX-License-Identifier: Apache-2.0
// Words of a stream that somebody's unit wrote, held against those of a vector set, and told as the bench tells them.
#ifndef HALFSPACE_TB_REPORT_COMPARE_WORDS_HPP_
#define HALFSPACE_TB_REPORT_COMPARE_WORDS_HPP_

#include <cstddef>
#include <string>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

struct Leniency {
  bool any_order = false;  // within what `any_order_within` of the stream names, as a triangle
  bool masked = false;     // fields that do not count by their `valid_if` may be anything
};

struct Comparison {
  std::size_t words = 0;  // compared, or there alone
  std::size_t different = 0, missing = 0, surplus = 0;
  std::string first;  // the first of these in a sentence; empty if there is none

  std::size_t wrong() const { return different + missing + surplus; }
};

// `stream` is one of `vectors` and has its words, as do streams that its valid_if names.
Comparison compare_words(const Vectors& vectors, const Stream& stream, const Words& got, const Leniency& leniency);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_COMPARE_WORDS_HPP_
