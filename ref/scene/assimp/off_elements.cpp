// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "ref/error.hpp"
#include "ref/scene/assimp/promised_elements.hpp"
#include "ref/scene/assimp/text_lines.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

constexpr double kMostCorners = 9;  // of a face: Assimp leaves out others

class Off {
 public:
  Off(const std::string& path, std::string_view text) : path_(path), lines_{text} {}

  void check() {
    std::string_view line;
    if (!next(&line)) return;
    std::string_view head = take_word(&line);
    const bool has_name = head.size() >= 3 && head.substr(head.size() - 3) == "OFF";
    if (has_name && (head.find('n') != head.npos || !read_kind(&line)))
      return;  // of kinds that Assimp knows or refuses
    read_counts(has_name, head, line);
    const double left = double(lines_.text.size() - lines_.at);
    if (vertices_ + faces_ > left) {
      throw Error(fmt::format(
          "{}: the header announces {:.0f} elements, but only {:.0f} bytes follow; copy or export the file again",
          path_, vertices_ + faces_, left));
    }
    for (double i = 0; i < vertices_; ++i) check_vertex(i);
    for (double i = 0; i < faces_; ++i) check_face(i);
  }

 private:
  [[noreturn]] void fail(const char* element, double number, const std::string& what) const {
    throw Error(
        fmt::format("{}: {} {:.0f} (line {}) {}; export the file again", path_, element, number, lines_.line, what));
  }

  // The next line with a word in it; without its comment.
  bool next(std::string_view* line) {
    while (lines_.next(line)) {
      *line = line->substr(0, line->find('#'));
      if (line->find_first_not_of(kBlank) != line->npos) return true;
    }
    return false;
  }

  // Behind the name: a word is BINARY, numbers are those of the next line.
  static bool read_kind(std::string_view* line) {
    std::string_view rest = *line;
    const std::string_view word = take_word(&rest);
    double number;
    return word.empty() || read_number(word, &number);
  }

  void read_counts(bool has_name, std::string_view head, std::string_view line) {
    if (!has_name) {
      first_ = head;
    } else if (line.find_first_not_of(kBlank) == line.npos) {
      next(&line);
    }
    double counts[3] = {};
    for (double& count : counts) {
      const std::string_view word = first_.empty() ? take_word(&line) : first_;
      first_ = {};
      if (!read_number(word, &count) || !(count >= 0) || count != std::floor(count)) {
        throw Error(
            fmt::format("{}: line {} does not have the numbers of vertices, faces and edges; export the file again",
                        path_, lines_.line));
      }
    }
    vertices_ = counts[0], faces_ = counts[1];
  }

  void check_vertex(double number) {
    std::string_view line;
    if (!next(&line)) fail("vertex", number, "is not there");
    int numbers = 0;
    for (std::string_view word; !(word = take_word(&line)).empty(); ++numbers) {
      double value;
      if (!read_number(word, &value)) {
        fail("vertex", number, fmt::format("has '{}' in the place of a number", one_line(std::string(word), 40)));
      }
    }
    if (numbers < 3) fail("vertex", number, "has fewer than three numbers");
  }

  void check_face(double number) {
    std::string_view line;
    if (!next(&line)) fail("face", number, "is not there");
    double corners = 0;
    if (!read_number(take_word(&line), &corners) || !(corners >= 1) || corners != std::floor(corners)) {
      fail("face", number, "does not say how many corners it has");
    }
    if (corners > kMostCorners) {
      fail("face", number, fmt::format("has {:.0f} corners, and its reader takes {:.0f}", corners, kMostCorners));
    }
    for (double i = 0; i < corners; ++i) {
      const std::string_view word = take_word(&line);
      if (word.empty())
        fail("face", number, fmt::format("says that it has {:.0f} corners, and has {:.0f}", corners, i));
      double index;
      if (!read_number(word, &index) || !(index >= 0) || index >= vertices_ || index != std::floor(index)) {
        fail("face", number,
             fmt::format("has the index '{}', and there are {:.0f} vertices", one_line(std::string(word), 40),
                         vertices_));
      }
    }
  }

  const std::string& path_;
  TextLines lines_;
  std::string_view first_;  // of the counts, where the file begins with them
  double vertices_ = 0, faces_ = 0;
};

}  // namespace

void check_off(const std::string& path, std::string_view text) { Off(path, text).check(); }

}  // namespace halfspace::ref
