// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/mtl.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "ref/scene/assimp/file_system.hpp"
#include "ref/scene/assimp/text_lines.hpp"

namespace halfspace::ref {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string_view word_of(std::string_view* text) {
  const std::string_view word = take_word(text);
  *text = trimmed(*text);
  return word;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = char(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// Up to `most` numbers, which are taken off; how many. What comes after them has to be there: a name may be a number.
int take_numbers(std::string_view* text, int most, double* values) {
  int count = 0;
  for (; count < most; ++count) {
    std::string_view rest = *text;
    const std::string_view word = word_of(&rest);
    if (!read_number(word, &values[count]) || rest.empty()) break;
    *text = rest;
  }
  return count;
}

MtlMap map_of(std::string_view text) {
  MtlMap map;
  while (!text.empty() && text[0] == '-') {
    const std::string option = lower(word_of(&text));
    double values[3] = {};
    if (option == "-s" || option == "-o" || option == "-t") {
      const int count = take_numbers(&text, 3, values);
      glm::dvec2& of = option == "-s" ? map.scale : map.offset;
      for (int i = 0; i < std::min(count, 2) && option != "-t"; ++i) of[i] = values[i];
    } else if (option == "-mm") {
      take_numbers(&text, 2, values);
    } else {
      const std::string value = lower(word_of(&text));
      if (option == "-clamp") map.repeats = value != "on";
    }
  }
  map.file = std::string(text);
  return map;
}

}  // namespace

void read_mtl(const std::string& path, std::map<std::string, MtlMaps>* materials) {
  const std::string text = text_of(path);
  MtlMaps* material = nullptr;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line(text.data() + at, end - at);
    at = end + 1;
    const std::string word = lower(word_of(&line));
    if (word == "newmtl") material = &(*materials)[std::string(line)];
    if (!material) continue;
    if (word == "map_kd") material->diffuse = map_of(line);
    if (word == "map_ke" || word == "map_emissive") material->emission = map_of(line);
  }
}

}  // namespace halfspace::ref
