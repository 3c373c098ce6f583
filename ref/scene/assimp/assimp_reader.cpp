// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/assimp_reader.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <new>
#include <utility>

#include "ref/error.hpp"
#include "ref/scene/assimp/assimp_materials.hpp"
#include "ref/scene/assimp/assimp_parts.hpp"
#include "ref/scene/assimp/file_system.hpp"
#include "ref/scene/assimp/mended_meshes.hpp"
#include "ref/scene/assimp/promised_elements.hpp"
#include "ref/scene/assimp/shifted_obj.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

constexpr char kMapping[] = "$tex.mapping";  // a property of a material
constexpr unsigned kSteps = aiProcess_ValidateDataStructure | aiProcess_Triangulate;

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

// Textures that are projected get coordinates: by a sphere, a cylinder or a plane, which Assimp can.
unsigned projection_step(const aiScene& file) {
  bool is_projected = false;
  for (unsigned i = 0; i < file.mNumMaterials; ++i) {
    const aiMaterial& material = *file.mMaterials[i];
    for (unsigned p = 0; p < material.mNumProperties; ++p) {
      const aiMaterialProperty& property = *material.mProperties[p];
      if (std::strcmp(property.mKey.C_Str(), kMapping) != 0 || property.mDataLength < sizeof(aiTextureMapping))
        continue;
      const auto mapping = *reinterpret_cast<const aiTextureMapping*>(property.mData);
      is_projected = is_projected || mapping == aiTextureMapping_SPHERE || mapping == aiTextureMapping_CYLINDER ||
                     mapping == aiTextureMapping_PLANE;
      if (mapping == aiTextureMapping_BOX) return 0;
    }
  }
  return is_projected && !(file.mFlags & AI_SCENE_FLAGS_NON_VERBOSE_FORMAT) ? unsigned(aiProcess_GenUVCoords) : 0;
}

// The importer, and what it has read.
struct Import {
  Assimp::Importer importer;
  FileSystem* files = new FileSystem;  // the importer deletes it
  LeftOut left_out;

  Import() {
    importer.SetIOHandler(files);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  }
  const aiScene& scene() const { return *importer.GetScene(); }
  void read(const std::string& path);
};

void Import::read(const std::string& path) {
  bool dropped = false;
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(new DroppedFaces(&dropped),
                                             Assimp::Logger::Warn);  // Assimp deletes it
  const bool is_read = importer.ReadFile(path, 0) != nullptr;
  if (is_read) left_out = mend_meshes(const_cast<aiScene*>(importer.GetScene()));
  const bool has_meshes = is_read && scene().mNumMeshes != 0;
  const bool is_good = has_meshes && importer.ApplyPostProcessing(kSteps | projection_step(scene())) != nullptr;
  Assimp::DefaultLogger::kill();
  if (is_read && !has_meshes) {
    throw Error(fmt::format("{}: there are no triangles in it; export a mesh of faces", path));
  }
  if (!is_good) {
    const std::string reason = one_line(importer.GetErrorString());
    if (reason == "std::bad_alloc") throw std::bad_alloc();
    throw Error(fmt::format("{}: cannot be read as a mesh ({}); check the file, or export it again", path,
                            reason.empty() ? "Assimp gives no reason" : reason));
  }
  if (dropped) throw Error(fmt::format("{}: faces have indices out of range; export the file again", path));
  if (!scene().mRootNode) {
    throw Error(fmt::format("{}: there are no triangles in it; export a mesh of faces", path));
  }
}

// An OBJ file whose coordinates are rounded too coarsely is read again, shifted; by how much.
glm::dvec3 read_nearer(const std::string& path, std::unique_ptr<Import>* import) {
  const aiScene& file = (*import)->scene();
  bool coarse = false;
  for (unsigned i = 0; i < file.mNumMeshes; ++i) coarse = coarse || coarseness(*file.mMeshes[i]) > kCoarse;
  if (!coarse || extension_of(path) != "obj") return glm::dvec3(0);
  ShiftedObj shifted = shifted_obj(text_of(path));
  auto again = std::make_unique<Import>();
  again->files->replace(path, std::move(shifted.text));
  again->read(path);
  *import = std::move(again);
  return shifted.origin;
}

// Of an OBJ file: its material libraries, as Assimp has found them.
std::map<std::string, MtlMaps> mtl_of(const Import& import, Document* document) {
  std::map<std::string, MtlMaps> materials;
  if (extension_of(document->name) != "obj") return materials;
  bool found = false;
  for (const std::string& path : import.files->opened()) {
    if (path == document->name) continue;
    read_mtl(path, &materials);
    found = true;
  }
  if (!found && !import.files->missing().empty()) {
    document->remarks.push_back(fmt::format("its material library '{}' is not there, and it is drawn grey",
                                            one_line(import.files->missing().front())));
  }
  return materials;
}

}  // namespace

Document read_by_assimp(const std::string& path, const ReadChoice& choice) {
  check_promised_elements(path);
  const Collada collada = read_collada(path);
  auto import = std::make_unique<Import>();
  import->read(path);
  Document document;
  document.name = path;
  const glm::dvec3 origin = read_nearer(path, &import);
  const aiScene& file = import->scene();
  document.remarks = import->left_out.remarks();
  const NodeNumbers numbers = add_nodes(file, &document);
  document.nodes[0].matrix = glm::translate(glm::dmat4(1), origin) * document.nodes[0].matrix;
  const auto places = add_materials(file, mtl_of(*import, &document), choice, &document);
  add_meshes(file, numbers, places, choice, &document);
  add_animations(file, numbers, &document);
  add_cameras(file, numbers, collada, &document);
  add_lights(file, numbers, &document);
  return document;
}

}  // namespace halfspace::ref
