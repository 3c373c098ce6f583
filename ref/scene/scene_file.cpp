// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/scene_file.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstring>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"
#include "ref/scene/pose.hpp"
#include "ref/scene/promised_elements.hpp"
#include "ref/scene/scene_file_parts.hpp"

namespace halfspace::ref {
namespace {

constexpr unsigned kSteps =
    aiProcess_ValidateDataStructure | aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals;
constexpr float kCreaseDegrees = 60;  // edges sharper than this stay edges when normals are made

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
  importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCreaseDegrees);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  bool dropped = false;
  Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
  Assimp::DefaultLogger::get()->attachStream(new DroppedFaces(&dropped),
                                             Assimp::Logger::Warn);  // Assimp deletes it
  const aiScene* file = importer.ReadFile(path, kSteps);
  Assimp::DefaultLogger::kill();
  if (!file) {
    const std::string reason = one_line(importer.GetErrorString());
    throw Error(fmt::format("{}: cannot be read as a mesh ({}); check the file, or export it again", path,
                            reason.empty() ? "Assimp gives no reason" : reason));
  }
  if (dropped) throw Error(fmt::format("{}: faces have indices out of range; export the file again", path));
  if (!file->mRootNode || file->mNumMeshes == 0) {
    throw Error(fmt::format("{}: there are no triangles in it; export a mesh of faces", path));
  }
  return file;
}

// A normal that a file leaves at zero, or at NaN, is that of a face at the vertex.
void mend_normals(Mesh* mesh) {
  const auto usable = [](double length) { return std::isfinite(length) && length > 0; };
  for (const auto& corner : mesh->triangles) {
    for (const std::uint32_t i : corner) {
      const double length = glm::length(mesh->normals[i]);
      if (usable(length)) {
        mesh->normals[i] /= length;
        continue;
      }
      const glm::dvec3& origin = mesh->positions[corner[0]];
      const glm::dvec3 normal = glm::cross(mesh->positions[corner[1]] - origin, mesh->positions[corner[2]] - origin);
      const double face_length = glm::length(normal);
      mesh->normals[i] = usable(face_length) ? normal / face_length : glm::dvec3(0, 1, 0);
    }
  }
}

Mesh mesh_of(const aiMesh& source, const std::string& path) {
  Mesh mesh;
  mesh.name = one_line(source.mName.C_Str());
  mesh.material = static_cast<int>(source.mMaterialIndex);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    mesh.positions.push_back(to_glm(source.mVertices[i]));
    mesh.normals.push_back(source.mNormals ? to_glm(source.mNormals[i]) : glm::dvec3(0));
    if (source.mTextureCoords[0])
      mesh.texture_coordinates.emplace_back(source.mTextureCoords[0][i].x, source.mTextureCoords[0][i].y);
    if (!source.mColors[0]) continue;
    const aiColor4D& c = source.mColors[0][i];
    mesh.colours.emplace_back(c.r, c.g, c.b);
  }
  for (unsigned i = 0; i < source.mNumFaces; ++i) {
    const aiFace& face = source.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines
    for (int v = 0; v < 3; ++v) {
      if (face.mIndices[v] < source.mNumVertices) continue;
      throw Error(fmt::format("{}: mesh '{}', face {}: index {} is beyond its {} vertices; export the file again", path,
                              mesh.name, i, face.mIndices[v], source.mNumVertices));
    }
    mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  mend_normals(&mesh);
  return mesh;
}

void add_instances(const aiScene& file, const aiNode& node, const Pose& pose, Scene* scene) {
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const int mesh = static_cast<int>(node.mMeshes[i]);
    const glm::dmat4& to_world = pose.to_world(&node);
    const aiMesh& source = *file.mMeshes[mesh];
    if (source.mNumBones == 0 && source.mNumAnimMeshes == 0) {
      scene->instances.push_back({mesh, to_world});
      continue;
    }
    Mesh moved = scene->meshes[mesh];
    if (source.mNumAnimMeshes != 0) morph(source, pose.morph_weights(node, source), &moved);
    const bool skinned = source.mNumBones != 0;
    if (skinned) skin(source, pose, to_world, &moved);
    scene->instances.push_back({static_cast<int>(scene->meshes.size()), skinned ? glm::dmat4(1) : to_world});
    scene->meshes.push_back(std::move(moved));
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) add_instances(file, *node.mChildren[i], pose, scene);
}

Scene geometry_at(const aiScene& file, const std::vector<Mesh>& meshes, const Pose& pose) {
  Scene scene;
  scene.meshes = meshes;
  add_instances(file, *file.mRootNode, pose, &scene);
  return scene;
}

std::vector<glm::dvec3> world_points(const Scene& scene) {
  std::vector<glm::dvec3> points;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const auto& corner : mesh.triangles) {
      for (const std::uint32_t i : corner) points.emplace_back(instance.to_world * glm::dvec4(mesh.positions[i], 1));
    }
  }
  return points;
}

}  // namespace

Scene read_scene_file(const std::string& path, double time_seconds, bool textured) {
  check_input_file(path);
  check_promised_elements(path);
  Assimp::Importer importer;
  const aiScene& file = *import(importer, path);

  std::vector<Mesh> meshes;
  for (unsigned i = 0; i < file.mNumMeshes; ++i) meshes.push_back(mesh_of(*file.mMeshes[i], path));
  const Pose start(file, 0), pose(file, time_seconds);
  Scene scene = geometry_at(file, meshes, pose);
  scene.framing = world_points(time_seconds == 0 ? scene : geometry_at(file, meshes, start));
  scene.name = path;
  scene.duration = start.duration();
  for (unsigned i = 0; i < file.mNumMaterials; ++i) scene.materials.push_back(material_of(*file.mMaterials[i]));
  if (textured) add_textures(file, path, &scene);
  scene.materials.emplace_back();  // light grey, for meshes without one
  for (Mesh& mesh : scene.meshes) {
    mesh.material = std::clamp(mesh.material, 0, static_cast<int>(scene.materials.size()) - 1);
  }
  if (file.mNumCameras > 0) {
    const std::string extension = extension_of(path);
    const std::optional<Camera> at_start = camera_of(*file.mCameras[0], start, extension);
    if (at_start && sees(*at_start, scene.framing)) scene.camera = camera_of(*file.mCameras[0], pose, extension);
  }
  add_lights(file, pose, &scene);
  return scene;
}

}  // namespace halfspace::ref
