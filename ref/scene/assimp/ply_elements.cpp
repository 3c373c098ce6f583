// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <string_view>
#include <vector>

#include "ref/error.hpp"
#include "ref/scene/assimp/promised_elements.hpp"
#include "ref/scene/assimp/text_lines.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

// As far as it is known, in bytes; 0: no type.
int bytes_of(std::string_view type) {
  static constexpr std::pair<const char*, int> kTypes[] = {{"char", 1},  {"uchar", 1},   {"int8", 1},   {"uint8", 1},
                                                           {"short", 2}, {"ushort", 2},  {"int16", 2},  {"uint16", 2},
                                                           {"int", 4},   {"uint", 4},    {"int32", 4},  {"uint32", 4},
                                                           {"float", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  for (const auto& [name, bytes] : kTypes) {
    if (type == name) return bytes;
  }
  return 0;
}

bool is_signed(std::string_view type) { return type[0] != 'u'; }
bool is_real(std::string_view type) { return type[0] == 'f' || type[0] == 'd'; }

struct Property {
  std::string_view count, type, name;  // count: of a list, else empty
  // Whose numbers are those of vertices.
  bool is_indices() const { return name == "vertex_indices" || name == "vertex_index"; }
};

struct Element {
  std::string_view name;
  double count = 0;
  std::vector<Property> properties;
};

class Ply {
 public:
  Ply(const std::string& path, std::string_view text) : path_(path), text_(text), lines_{text} {}

  void check() {
    read_header();
    const double promised = count();
    // A text element is a line, a binary one a byte at least.
    const double found = is_text_ ? lines_left() : double(text_.size() - lines_.at);
    if (promised > found) {
      throw Error(fmt::format(
          "{}: the header announces {:.0f} elements, but only {:.0f} {} follow; copy or export the file again", path_,
          promised, found, is_text_ ? "lines" : "bytes"));
    }
    for (const Element& element : elements_) {
      for (double i = 0; i < element.count; ++i) is_text_ ? check_line(element, i) : check_bytes(element, i);
    }
  }

 private:
  [[noreturn]] void fail(const Element& element, double number, const std::string& what) const {
    const std::string line = is_text_ ? fmt::format(" (line {})", lines_.line) : "";
    throw Error(fmt::format("{}: {} {:.0f}{} {}; export the file again", path_, one_line(std::string(element.name)),
                            number, line, what));
  }

  void read_header() {
    for (std::string_view line; lines_.next(&line);) {
      const auto words = words_of(line);
      if (words.empty()) continue;
      if (words[0] == "format" && words.size() > 1) {
        is_text_ = words[1] == "ascii";
        is_big_ = words[1] == "binary_big_endian";
      } else if (words[0] == "element" && words.size() > 2) {
        Element element{words[1], 0, {}};
        if (!read_number(words[2], &element.count) || !(element.count >= 0) || element.count > 1e12) {
          throw Error(fmt::format("{}: element '{}' is announced '{}' times, which is no count; export the file again",
                                  path_, one_line(std::string(words[1])), one_line(std::string(words[2]))));
        }
        elements_.push_back(element);
      } else if (words[0] == "property") {
        add_property(words);
      } else if (words[0] == "end_header") {
        for (const Element& element : elements_) {
          if (element.name == "vertex") vertices_ = element.count;
        }
        return;
      }
    }
    throw Error(fmt::format("{}: the header has no end; copy or export the file again", path_));
  }

  void add_property(const std::vector<std::string_view>& words) {
    Property property;
    if (words.size() > 4 && words[1] == "list") {
      property = {words[2], words[3], words[4]};
    } else if (words.size() > 2) {
      property = {{}, words[1], words[2]};
    }
    const bool is_good = bytes_of(property.type) != 0 && (property.count.empty() || bytes_of(property.count) != 0);
    if (elements_.empty() || !is_good) {
      throw Error(fmt::format("{}: line {} of the header is no property of an element; export the file again", path_,
                              lines_.line));
    }
    elements_.back().properties.push_back(property);
  }

  double count() const {
    double sum = 0;
    for (const Element& element : elements_) sum += element.count;
    return sum;
  }

  double lines_left() const {
    double lines = 0;
    bool blank = true;
    for (std::size_t i = lines_.at; i < text_.size(); ++i) {
      const char c = text_[i];
      if (c == '\n') blank = true;
      if (blank && c != '\n' && c != ' ' && c != '\t' && c != '\r') ++lines, blank = false;
    }
    return lines;
  }

  void check_index(const Element& element, double number, double index) const {
    if (index >= 0 && index < vertices_ && index == std::floor(index)) return;
    fail(element, number, fmt::format("has the index {}, and there are {:.0f} vertices", index, vertices_));
  }

  // The next word of the line; false at its end. Error if it is no number.
  bool next_number(std::string_view* line, const Element& element, double number, double* value) const {
    const std::string_view word = take_word(line);
    if (word.empty()) return false;
    if (!read_number(word, value)) {
      fail(element, number, fmt::format("has '{}' in the place of a number", one_line(std::string(word), 40)));
    }
    return true;
  }

  void check_line(const Element& element, double number) {
    std::string_view line;
    do {
      if (!lines_.next(&line)) return;
    } while (line.find_first_not_of(kBlank) == line.npos);
    double value = 0;
    for (const Property& property : element.properties) {
      if (property.count.empty()) {
        if (!next_number(&line, element, number, &value))
          fail(element, number, "has fewer numbers than the header says");
        continue;
      }
      double entries = 0;
      if (!next_number(&line, element, number, &entries) || !(entries >= 0) || entries != std::floor(entries)) {
        fail(element, number, "does not say how many numbers follow");
      }
      for (double i = 0; i < entries; ++i) {
        if (!next_number(&line, element, number, &value)) {
          fail(element, number, fmt::format("says that {:.0f} numbers follow, and has {:.0f}", entries, i));
        }
        if (property.is_indices()) check_index(element, number, value);
      }
    }
    if (!take_word(&line).empty()) fail(element, number, "has more numbers than the header says");
  }

  double whole_number(std::string_view type, std::size_t at) const {
    const int bytes = bytes_of(type);
    if (is_real(type)) return real_number(bytes, at);
    std::uint64_t bits = 0;
    for (int i = 0; i < bytes; ++i) {
      bits |= std::uint64_t(std::uint8_t(text_[at + std::size_t(i)])) << 8 * (is_big_ ? bytes - 1 - i : i);
    }
    const double value = double(bits);
    return is_signed(type) && bits >> (8 * bytes - 1) != 0 ? value - std::ldexp(1.0, 8 * bytes) : value;
  }

  double real_number(int bytes, std::size_t at) const {
    char raw[8] = {};
    for (int i = 0; i < bytes; ++i) raw[is_big_ ? bytes - 1 - i : i] = text_[at + std::size_t(i)];
    float single;
    double twofold;
    std::memcpy(&single, raw, sizeof single);
    std::memcpy(&twofold, raw, sizeof twofold);
    return bytes == 4 ? double(single) : twofold;
  }

  void check_bytes(const Element& element, double number) {
    for (const Property& property : element.properties) {
      double entries = 1;
      if (!property.count.empty()) {
        const std::size_t bytes = std::size_t(bytes_of(property.count));
        if (bytes > text_.size() - lines_.at) fail(element, number, "is cut");
        entries = whole_number(property.count, lines_.at);
        lines_.at += bytes;
        if (!(entries >= 0) || entries != std::floor(entries))
          fail(element, number, "does not say how many numbers follow");
      }
      const std::size_t bytes = std::size_t(bytes_of(property.type));
      if (entries * double(bytes) > double(text_.size() - lines_.at)) {
        if (property.count.empty()) fail(element, number, "is cut");
        fail(element, number, fmt::format("says that {:.0f} numbers follow, and the file ends before", entries));
      }
      if (!property.count.empty() && property.is_indices()) {
        for (double i = 0; i < entries; ++i)
          check_index(element, number, whole_number(property.type, lines_.at + std::size_t(i) * bytes));
      }
      lines_.at += std::size_t(entries) * bytes;
    }
  }

  const std::string& path_;
  std::string_view text_;
  TextLines lines_;
  bool is_text_ = true, is_big_ = false;
  std::vector<Element> elements_;
  double vertices_ = 0;
};

}  // namespace

void check_ply(const std::string& path, std::string_view text) { Ply(path, text).check(); }

}  // namespace halfspace::ref
