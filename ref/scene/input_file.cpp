// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/input_file.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ref/error.hpp"

namespace halfspace::ref {

void check_input_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw Error(fmt::format("{}: is a folder; name a file in it", path));
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    const char* reason = errno ? std::strerror(errno) : "it cannot be read";
    throw Error(fmt::format("{}: cannot be opened ({}); check the path", path, reason));
  }
  if (file.peek() == std::ifstream::traits_type::eof()) {
    throw Error(fmt::format("{}: the file is empty; export it again", path));
  }
}

std::string one_line(const std::string& text, std::size_t limit) {
  std::string line;
  for (const char c : text) {
    if (line.size() >= limit) return line + "...";
    const bool printable = std::isprint(static_cast<unsigned char>(c)) && c != ' ';
    if (printable) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace halfspace::ref
