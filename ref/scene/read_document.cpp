// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/read_document.hpp"

#include "ref/scene/assimp/assimp_reader.hpp"
#include "ref/scene/check_document.hpp"
#include "ref/scene/gltf/read_gltf.hpp"
#include "ref/scene/guard/guarded_read.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

Document read_by_format(const std::string& path, const ReadChoice& choice) {
  const std::string extension = extension_of(path);
  if (extension != "gltf" && extension != "glb") return read_by_assimp(path, choice);
  try {
    return read_gltf(path, choice);
  } catch (const FirstGltf&) {
    return read_by_assimp(path, choice);
  }
}

}  // namespace

Document read_document(const std::string& path, const SceneChoice& choice) {
  check_input_file(path);
  const auto read = [&] { return read_by_format(path, {choice.textured}); };
  Document document = choice.trust ? read() : guarded_read(path, read, limits_of(path));
  check_document(document);
  return document;
}

}  // namespace halfspace::ref
