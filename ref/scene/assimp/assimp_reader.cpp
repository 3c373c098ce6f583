// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/assimp_reader.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <cstring>
#include <new>

#include "ref/error.hpp"
#include "ref/scene/assimp/assimp_parts.hpp"
#include "ref/scene/assimp/promised_elements.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

constexpr unsigned kSteps = aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType;

// Assimp drops faces whose indices are out of range, and tells only its log.
class DroppedFaces : public Assimp::LogStream {
 public:
  explicit DroppedFaces(bool* found) : found_(found) {}
  void write(const char* message) override {
    if (std::strstr(message, "out-of-range indices")) *found_ = true;
  }

 private:
  bool* found_;
};

const aiScene* import(Assimp::Importer& importer, const std::string& path) {
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  bool dropped = false;
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(new DroppedFaces(&dropped),
                                             Assimp::Logger::Warn);  // Assimp deletes it
  const aiScene* file = importer.ReadFile(path, kSteps);
  Assimp::DefaultLogger::kill();
  if (!file) {
    const std::string reason = one_line(importer.GetErrorString());
    if (reason == "std::bad_alloc") throw std::bad_alloc();
    throw Error(fmt::format("{}: cannot be read as a mesh ({}); check the file, or export it again", path,
                            reason.empty() ? "Assimp gives no reason" : reason));
  }
  if (dropped) throw Error(fmt::format("{}: faces have indices out of range; export the file again", path));
  if (!file->mRootNode || file->mNumMeshes == 0) {
    throw Error(fmt::format("{}: there are no triangles in it; export a mesh of faces", path));
  }
  return file;
}

}  // namespace

Document read_by_assimp(const std::string& path, const ReadChoice& choice) {
  check_promised_elements(path);
  Assimp::Importer importer;
  const aiScene& file = *import(importer, path);
  Document document;
  document.name = path;
  const NodeNumbers numbers = add_nodes(file, &document);
  add_meshes(file, numbers, &document);
  add_animations(file, numbers, &document);
  add_cameras(file, numbers, &document);
  add_lights(file, numbers, &document);
  add_materials(file, &document);
  if (choice.textured) add_textures(file, &document);
  return document;
}

}  // namespace halfspace::ref
