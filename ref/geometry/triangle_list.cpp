// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/triangle_list.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <ostream>
#include <string_view>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

class TriReader {
 public:
  explicit TriReader(const std::string& path) : path_(path) {}

  TriangleList read(bool may_be_empty) {
    check_input_file(path_);
    std::ifstream file(path_, std::ios::binary);
    for (std::string line; std::getline(file, line);) {
      ++line_;
      cut_ = file.eof();
      split(line);
      if (!fields_.empty()) read_line();
    }
    if (file.bad()) throw Error(fmt::format("{}:{}: the file cannot be read further; check the disk", path_, line_));
    if (!sized_) throw Error(fmt::format("{}: there is no line 'size W H'; put it first", path_));
    if (list_.triangles.empty() && !may_be_empty)
      throw Error(fmt::format("{}: there are no triangles; add a line 't ...'", path_));
    return std::move(list_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", path_, line_, what)); }

  void split(const std::string& line) {
    constexpr const char* kBlank = " \t\r\v\f";
    fields_.clear();
    const std::string_view text = std::string_view(line).substr(0, line.find('#'));
    for (std::size_t begin = text.find_first_not_of(kBlank); begin != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(kBlank, begin), text.size());
      fields_.push_back(text.substr(begin, end - begin));
      begin = text.find_first_not_of(kBlank, end);
    }
  }

  void read_line() {
    const std::string_view word = fields_[0];
    if (word == "size") {
      read_size();
    } else if (word == "background" || word == "t") {
      if (!sized_) fail(fmt::format("'{}' comes before the line 'size W H'; put that line first", word));
      word == "t" ? read_triangle() : read_background();
    } else {
      fail(fmt::format("'{}' is not a line of a .tri file; a line starts with size, background, t or #",
                       one_line(std::string(word), 20)));
    }
  }

  void expect_numbers(std::size_t count, const char* form) const {
    const std::size_t got = fields_.size() - 1;
    if (got == count) return;
    if (got < count && cut_) {
      fail(fmt::format("the file ends in the middle of a line ({} numbers of {}); copy it again", got, count));
    }
    fail(fmt::format("{} numbers where {} are needed; write '{}'", got, count, form));
  }

  double number(std::size_t field) const {
    const std::string_view text = fields_[field];
    double value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault == std::errc::result_out_of_range) {
      fail(fmt::format("field {}: '{}' is beyond a double; write a smaller number", field + 1,
                       one_line(std::string(text), 20)));
    }
    if (fault != std::errc() || end != text.data() + text.size()) {
      fail(fmt::format("field {}: '{}' is not a number; write one like -12.5", field + 1,
                       one_line(std::string(text), 20)));
    }
    if (!std::isfinite(value))
      fail(fmt::format("field {}: '{}' is not finite; write a finite number", field + 1, text));
    return value;
  }

  double number_in(std::size_t field, const char* what, double low, double high) const {
    const double value = number(field);
    if (value < low || value > high) {
      fail(fmt::format("field {}: {} = {} is outside [{}, {}]; write a number in it", field + 1, what, value, low,
                       high));
    }
    return value;
  }

  int side(std::size_t field, const char* what) const {
    const double value = number_in(field, what, 1, kLargestSide);
    if (value != std::floor(value))
      fail(fmt::format("field {}: {} = {} is not whole; write whole pixels", field + 1, what, value));
    return static_cast<int>(value);
  }

  void read_size() {
    if (sized_) fail("a second line 'size'; keep one, as a file is one frame");
    expect_numbers(2, "size W H");
    list_.width = side(1, "width");
    list_.height = side(2, "height");
    sized_ = true;
  }

  void read_background() {
    expect_numbers(3, "background r g b");
    for (int c = 0; c < 3; ++c) list_.background[c] = number_in(1 + c, "colour", 0, 255);
  }

  void read_triangle() {
    expect_numbers(18, "t x y z r g b  x y z r g b  x y z r g b");
    std::array<Vertex, 3> triangle;
    for (int v = 0; v < 3; ++v) {
      const std::size_t at = 1 + 6 * v;
      triangle[v] = {number(at),
                     number(at + 1),
                     number_in(at + 2, "z", 0, 1),
                     number_in(at + 3, "r", 0, 255),
                     number_in(at + 4, "g", 0, 255),
                     number_in(at + 5, "b", 0, 255)};
    }
    list_.triangles.push_back(triangle);
  }

  const std::string& path_;
  TriangleList list_{};
  int line_ = 0;
  bool cut_ = false;  // the line at hand has no end of line
  bool sized_ = false;
  std::vector<std::string_view> fields_;
};

// to_chars without a format is the shortest text that reads back the same.
void put(std::string& line, double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  line += ' ';
  line.append(text, result.ptr);
}

}  // namespace

bool is_tri_file(const std::string& path) { return extension_of(path) == "tri"; }

TriangleList read_tri(const std::string& path, bool may_be_empty) { return TriReader(path).read(may_be_empty); }

void write_tri(std::ostream& out, const TriangleList& list) {
  out << "size " << list.width << ' ' << list.height << '\n';
  if (list.background != std::array<double, 3>{0, 0, 0}) {
    std::string line = "background";
    for (const double channel : list.background) put(line, channel);
    out << line << '\n';
  }
  for (const auto& triangle : list.triangles) {
    std::string line = "t";
    for (const Vertex& v : triangle) {
      if (&v != &triangle[0]) line += ' ';
      for (const double value : {v.x, v.y, v.z, v.r, v.g, v.b}) put(line, value);
    }
    out << line << '\n';
  }
}

}  // namespace halfspace::ref
