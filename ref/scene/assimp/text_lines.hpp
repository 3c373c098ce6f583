// SPDX-License-Identifier: Apache-2.0
// Lines and words of text formats, for what is checked before Assimp reads them.
#ifndef HALFSPACE_REF_SCENE_ASSIMP_TEXT_LINES_HPP_
#define HALFSPACE_REF_SCENE_ASSIMP_TEXT_LINES_HPP_

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string_view>
#include <vector>

namespace halfspace::ref {

constexpr const char* kBlank = " \t\r";

struct TextLines {
  std::string_view text;
  std::size_t at = 0, line = 0;  // line: the number of the last one, from 1 on

  bool next(std::string_view* out) {
    if (at >= text.size()) return false;
    const std::size_t end = std::min(text.find('\n', at), text.size());
    *out = text.substr(at, end - at);
    at = std::min(end + 1, text.size());
    ++line;
    return true;
  }
};

// Takes off the first word; empty at the end.
inline std::string_view take_word(std::string_view* line) {
  const std::size_t first = std::min(line->find_first_not_of(kBlank), line->size());
  const std::size_t end = std::min(line->find_first_of(kBlank, first), line->size());
  const std::string_view word = line->substr(first, end - first);
  line->remove_prefix(end);
  return word;
}

inline std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word; !(word = take_word(&line)).empty();) words.push_back(word);
  return words;
}

// All of the word is a number; one out of range is, too.
inline bool read_number(std::string_view word, double* value) {
  if (!word.empty() && word[0] == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), *value);
  return error != std::errc::invalid_argument && end == word.data() + word.size();
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_ASSIMP_TEXT_LINES_HPP_
