// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/promised_elements.hpp"

#include <fstream>

#include "ref/scene/assimp/file_system.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
void check_promised_elements(const std::string& path) {
  char start[4] = {};
  std::ifstream(path, std::ios::binary).read(start, sizeof start);
  const std::string_view word(start, sizeof start);  // Assimp goes by it where the name says nothing
  const std::string extension = extension_of(path);
  if (extension == "ply" || word == "ply\n" || word == "ply\r") check_ply(path, text_of(path));
  if (extension == "off" || word == "OFF\n" || word == "OFF\r") check_off(path, text_of(path));
}

}  // namespace halfspace::ref
