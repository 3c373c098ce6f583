// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/mended_meshes.hpp"

#include <assimp/mesh.h>
#include <fmt/format.h>

#include <cstring>
#include <utility>

namespace halfspace::ref {
namespace {

constexpr char kOfBones[] = "SkeletonMaterial";  // what Assimp gives to the meshes that it makes of bones

void mend(aiMesh* mesh, LeftOut* left_out) {
  unsigned kept = 0;
  mesh->mPrimitiveTypes = 0;
  for (unsigned i = 0; i < mesh->mNumFaces; ++i) {
    aiFace& face = mesh->mFaces[i];
    const unsigned corners = face.mIndices ? face.mNumIndices : 0;
    left_out->empty += corners == 0;
    left_out->points += corners == 1;
    left_out->lines += corners == 2;
    if (corners < 3) continue;
    mesh->mPrimitiveTypes |= corners == 3 ? aiPrimitiveType_TRIANGLE : aiPrimitiveType_POLYGON;
    if (kept != i) {
      std::swap(mesh->mFaces[kept].mIndices, face.mIndices);
      std::swap(mesh->mFaces[kept].mNumIndices, face.mNumIndices);
    }
    ++kept;
  }
  mesh->mNumFaces = kept;
}

bool is_of_bones(const aiScene& file, const aiMesh& mesh) {
  aiString name;
  return mesh.mMaterialIndex < file.mNumMaterials &&
         file.mMaterials[mesh.mMaterialIndex]->Get(AI_MATKEY_NAME, name) == AI_SUCCESS &&
         std::strcmp(name.C_Str(), kOfBones) == 0;
}

}  // namespace

std::vector<std::string> LeftOut::remarks() const {
  std::vector<std::string> sentences;
  const auto say = [&](std::size_t count, const char* one, const char* many) {
    if (count == 1) sentences.push_back(fmt::format("1 {} is left out", one));
    if (count > 1) sentences.push_back(fmt::format("{} {} are left out", count, many));
  };
  say(lines, "line", "lines");
  say(points, "point", "points");
  say(empty, "face without corners", "faces without corners");
  return sentences;
}

LeftOut mend_meshes(aiScene* file) {
  LeftOut left_out;
  std::vector<int> number(file->mNumMeshes, -1);
  unsigned kept = 0;
  for (unsigned i = 0; i < file->mNumMeshes; ++i) {
    aiMesh* const mesh = file->mMeshes[i];
    const bool of_bones = is_of_bones(*file, *mesh);
    if (!of_bones) mend(mesh, &left_out);
    if (of_bones || mesh->mNumFaces == 0) {
      delete mesh;
      continue;
    }
    number[i] = int(kept);
    file->mMeshes[kept++] = mesh;
  }
  file->mNumMeshes = kept;
  std::vector<aiNode*> waiting;
  if (file->mRootNode) waiting.push_back(file->mRootNode);
  while (!waiting.empty()) {
    aiNode* const node = waiting.back();
    waiting.pop_back();
    unsigned meshes = 0;
    for (unsigned i = 0; i < node->mNumMeshes; ++i) {
      const unsigned of = node->mMeshes[i];
      if (of < number.size() && number[of] >= 0) node->mMeshes[meshes++] = unsigned(number[of]);
    }
    node->mNumMeshes = meshes;
    waiting.insert(waiting.end(), node->mChildren, node->mChildren + node->mNumChildren);
  }
  return left_out;
}

}  // namespace halfspace::ref
