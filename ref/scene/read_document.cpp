// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/read_document.hpp"

#include "ref/scene/assimp/assimp_reader.hpp"
#include "ref/scene/check_document.hpp"
#include "ref/scene/guard/guarded_read.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {

Document read_document(const std::string& path, const SceneChoice& choice) {
  check_input_file(path);
  const auto read = [&] { return read_by_assimp(path, {choice.textured}); };
  Document document = choice.trust ? read() : guarded_read(path, read, limits_of(path));
  check_document(document);
  return document;
}

}  // namespace halfspace::ref
