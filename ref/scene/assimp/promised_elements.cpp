// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/promised_elements.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

[[noreturn]] void fail(const std::string& path, double promised, double found, const char* unit) {
  throw Error(
      fmt::format("{}: the header announces {:.0f} elements, but only {:.0f} {} follow; copy or export the file again",
                  path, promised, found, unit));
}

// What is left of a file, in lines that are not blank, and in bytes.
struct Rest {
  double lines = 0, bytes = 0;
  explicit Rest(std::istream& file) {
    for (std::string line; std::getline(file, line);) {
      bytes += double(line.size()) + 1;
      lines += line.find_first_not_of(" \t\r") != std::string::npos;
    }
  }
};

// A text element is a line, a binary one a byte at least.
void check_ply(const std::string& path, std::istream& file) {
  double promised = 0;
  bool text = true;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word, kind;
    double count = 0;
    words >> word;
    if (word == "format" && words >> kind) text = kind == "ascii";
    if (word == "element" && words >> kind >> count) promised += count;
    if (word == "end_header") {
      const Rest rest(file);
      const double found = text ? rest.lines : rest.bytes;
      if (promised > found) fail(path, promised, found, text ? "lines" : "bytes");
      return;
    }
  }
  throw Error(fmt::format("{}: the header has no end; copy or export the file again", path));
}

// "OFF", then the numbers of vertices, faces and edges; edges are not listed.
void check_off(const std::string& path, std::istream& file) {
  std::string word;
  double vertices = 0, faces = 0;
  if (!(file >> word >> vertices >> faces)) return;  // not of this form: Assimp may know it
  const Rest rest(file);
  if (vertices + faces > rest.bytes) fail(path, vertices + faces, rest.bytes, "bytes");
}

}  // namespace

void check_promised_elements(const std::string& path) {
  const std::string extension = extension_of(path);
  std::ifstream file(path, std::ios::binary);
  if (extension == "ply") check_ply(path, file);
  if (extension == "off") check_off(path, file);
}

}  // namespace halfspace::ref
