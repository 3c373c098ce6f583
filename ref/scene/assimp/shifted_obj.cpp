// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/shifted_obj.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

namespace halfspace::ref {
namespace {

// "v x y z", and what comes behind it; not with a fourth number, which divides.
struct VertexLine {
  bool is_vertex = false, is_good = false;
  glm::dvec3 position{0};
  std::string_view rest;

  explicit VertexLine(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == line.npos || line.size() < first + 2 || line[first] != 'v' ||
        (line[first + 1] != ' ' && line[first + 1] != '\t'))
      return;
    is_vertex = true;
    rest = line.substr(first + 1);
    for (int i = 0; i < 3; ++i) {
      rest = rest.substr(std::min(rest.find_first_not_of(" \t"), rest.size()));
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), position[i]);
      if (error != std::errc() || !std::isfinite(position[i])) return;
      rest = rest.substr(std::size_t(end - rest.data()));
    }
    std::size_t words = 0;
    for (std::size_t i = 0; i < rest.size(); ++i)
      words += is_space(rest[i]) && i + 1 < rest.size() && !is_space(rest[i + 1]);
    is_good = words != 1;
  }

  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
};

template <class Take>
void for_each_line(const std::string& text, Take take) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    take(std::string_view(text).substr(at, end - at));
    at = end + 1;
  }
}

}  // namespace

ShiftedObj shifted_obj(const std::string& text) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  bool is_good = true;
  for_each_line(text, [&](std::string_view line) {
    const VertexLine vertex(line);
    is_good = is_good && vertex.is_vertex == vertex.is_good;
    if (vertex.is_good) low = glm::min(low, vertex.position), high = glm::max(high, vertex.position);
  });
  ShiftedObj out;
  if (!is_good || !(low.x <= high.x)) return {text, glm::dvec3(0)};
  out.origin = glm::round((low + high) / 2.0);
  out.text.reserve(text.size());
  for_each_line(text, [&](std::string_view line) {
    const VertexLine vertex(line);
    if (vertex.is_good) {
      const glm::dvec3 p = vertex.position - out.origin;
      fmt::format_to(std::back_inserter(out.text), "v {} {} {}{}\n", p.x, p.y, p.z, vertex.rest);
    } else {
      out.text.append(line).push_back('\n');
    }
  });
  return out;
}

}  // namespace halfspace::ref
