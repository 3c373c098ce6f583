// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/read_document.hpp"

#include "ref/scene/assimp/assimp_reader.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {

Document read_document(const std::string& path, const SceneChoice& choice) {
  check_input_file(path);
  return read_by_assimp(path, {choice.textured});
}

}  // namespace halfspace::ref
