// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/promised_elements.hpp"

#include <fmt/format.h>

#include <fstream>

#include "ref/error.hpp"
#include "ref/scene/assimp/file_system.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

// "OFF", then the numbers of vertices, faces and edges; edges are not listed. Each takes a byte at least.
void check_off(const std::string& path, std::istream& file) {
  std::string word;
  double vertices = 0, faces = 0;
  if (!(file >> word >> vertices >> faces)) return;  // not of this form: Assimp may know it
  const auto start = file.tellg();
  file.seekg(0, std::ios::end);
  const double left = double(file.tellg() - start);
  if (vertices + faces <= left) return;
  throw Error(fmt::format(
      "{}: the header announces {:.0f} elements, but only {:.0f} bytes follow; copy or export the file again", path,
      vertices + faces, left));
}

}  // namespace

void check_promised_elements(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension == "ply") check_ply(path, text_of(path));
  std::ifstream file(path, std::ios::binary);
  if (extension == "off") check_off(path, file);
}

}  // namespace halfspace::ref
