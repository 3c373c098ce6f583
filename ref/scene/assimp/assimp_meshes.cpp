// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "ref/error.hpp"
#include "ref/scene/assimp/assimp_parts.hpp"
#include "ref/scene/input_file.hpp"
#include "ref/scene/normals.hpp"

namespace halfspace::ref {
namespace {

constexpr double kCreaseDegrees = 60;  // edges sharper than this stay edges when normals are made

Mesh mesh_of(const aiMesh& source, const std::string& path) {
  Mesh mesh;
  mesh.name = one_line(source.mName.C_Str());
  mesh.material = static_cast<int>(source.mMaterialIndex);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    mesh.positions.push_back(to_glm(source.mVertices[i]));
    if (source.mNormals) mesh.normals.push_back(to_glm(source.mNormals[i]));
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
  return mesh;
}

// Of a relative target what is added, of another where it ends.
void add_targets(const aiMesh& source, DocumentMesh* mesh) {
  const double less = source.mMethod == aiMorphingMethod_MORPH_RELATIVE ? 0 : 1;
  const auto differences = [&](const aiVector3D* values, unsigned count, const std::vector<glm::dvec3>& base) {
    std::vector<glm::dvec3> out;
    if (!values || count != base.size()) return out;
    for (std::size_t v = 0; v < base.size(); ++v) out.push_back(to_glm(values[v]) - less * base[v]);
    return out;
  };
  for (unsigned i = 0; i < source.mNumAnimMeshes; ++i) {
    const aiAnimMesh& target = *source.mAnimMeshes[i];
    mesh->targets.push_back({differences(target.mVertices, target.mNumVertices, mesh->mesh.positions),
                             differences(target.mNormals, target.mNumVertices, mesh->mesh.normals), target.mWeight});
  }
}

void add_skin(const aiMesh& source, const NodeNumbers& numbers, DocumentMesh* mesh, Document* document) {
  Skin skin;
  for (unsigned i = 0; i < source.mNumBones; ++i) {
    const aiBone& bone = *source.mBones[i];
    const auto node = numbers.find(bone.mName.C_Str());
    skin.push_back({node == numbers.end() ? -1 : node->second, to_glm(bone.mOffsetMatrix)});
    for (unsigned w = 0; w < bone.mNumWeights; ++w) {
      const aiVertexWeight& weight = bone.mWeights[w];
      if (weight.mVertexId < source.mNumVertices) mesh->joint_weights.push_back({weight.mVertexId, i, weight.mWeight});
    }
  }
  mesh->skin = int(document->skins.size());
  document->skins.push_back(std::move(skin));
}

}  // namespace

void add_meshes(const aiScene& file, const NodeNumbers& numbers, Document* document) {
  for (unsigned i = 0; i < file.mNumMeshes; ++i) {
    const aiMesh& source = *file.mMeshes[i];
    DocumentMesh mesh;
    mesh.mesh = mesh_of(source, document->name);
    if (source.mNumBones != 0) add_skin(source, numbers, &mesh, document);
    if (mesh.mesh.normals.empty()) {
      add_targets(source, &mesh);
      split_vertices(&mesh);
      make_smooth(&mesh.mesh, kCreaseDegrees);
    } else {
      mend_normals(&mesh.mesh);
      add_targets(source, &mesh);
    }
    document->meshes.push_back(std::move(mesh));
  }
}

}  // namespace halfspace::ref
