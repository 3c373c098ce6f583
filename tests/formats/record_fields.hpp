// SPDX-License-Identifier: Apache-2.0
// The fields of records in tests: any bits in each, and all of a stream's words as integers to compare.
#ifndef HALFSPACE_TESTS_FORMATS_RECORD_FIELDS_HPP_
#define HALFSPACE_TESTS_FORMATS_RECORD_FIELDS_HPP_

#include <cstdint>
#include <random>
#include <vector>

#include "hls/numbers/fixed.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace::tests {

// For visit().
struct Randomize {
  std::mt19937_64& bits;

  template <class T>
  void operator()(const char*, T& field) {
    field = from_raw<T>(bits());
  }
  template <class T, std::size_t N>
  void lanes(const char* name, T (&fields)[N]) {
    for (T& field : fields) (*this)(name, field);
  }
};

// In the order of visit().
struct Fields {
  std::vector<std::int64_t> values;

  template <class T>
  void operator()(const char*, const T& field) {
    values.push_back(std::int64_t(raw(field)));
  }
  template <class T, std::size_t N>
  void lanes(const char* name, const T (&fields)[N]) {
    for (const T& field : fields) (*this)(name, field);
  }
};
template <class T>
std::vector<std::int64_t> fields_of(std::vector<T> words) {
  Fields fields;
  for (T& word : words) word.visit(fields);
  return fields.values;
}
template <class T>
std::vector<std::int64_t> drain(Stream<T>& stream) {
  std::vector<T> words;
  while (!stream.empty()) words.push_back(stream.read());
  return fields_of(words);
}

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_RECORD_FIELDS_HPP_
