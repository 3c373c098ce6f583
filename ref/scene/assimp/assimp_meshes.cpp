// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "ref/error.hpp"
#include "ref/scene/assimp/assimp_parts.hpp"
#include "ref/scene/input_file.hpp"
#include "ref/scene/normals.hpp"

namespace halfspace::ref {
namespace {

constexpr double kCreaseDegrees = 60;  // edges sharper than this stay edges when normals are made
constexpr double kEdge = 1e-4;         // of a texture: coordinates that leave it by less do not leave it

// An importer says "no colour" by zeros, or by a number below 0.
bool is_none(const aiColor4D& c) {
  return (c.r == 0 && c.g == 0 && c.b == 0 && c.a == 0) || c.r < 0 || c.g < 0 || c.b < 0 || c.a < 0;
}

// None where no vertex has one; else white for those without. Those of an OFF file may be of 0-255.
std::vector<glm::dvec3> colours_of(const aiMesh& source, bool is_off, bool* has_alpha) {
  std::vector<glm::dvec3> colours;
  const aiColor4D* const from = source.mColors[0];
  if (!from || std::all_of(from, from + source.mNumVertices, is_none)) return colours;
  const auto exceeds = [](const aiColor4D& c) { return std::max({c.r, c.g, c.b}) > 1; };
  const double full = is_off && std::any_of(from, from + source.mNumVertices, exceeds) ? 255 : 1;
  colours.reserve(source.mNumVertices);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const bool none = is_none(from[i]);
    *has_alpha = *has_alpha || (!none && from[i].a < full);
    colours.push_back(none ? glm::dvec3(1) : glm::clamp(glm::dvec3(from[i].r, from[i].g, from[i].b) / full, 0.0, 1.0));
  }
  return colours;
}

// Of a textured mesh, where its texture lies.
std::vector<glm::dvec2> coordinates_of(const aiMesh& source, const TexturePlace& place, bool* leaves) {
  std::vector<glm::dvec2> coordinates;
  const aiVector3D* from =
      place.coordinates < AI_MAX_NUMBER_OF_TEXTURECOORDS ? source.mTextureCoords[place.coordinates] : nullptr;
  if (!from) from = source.mTextureCoords[0];
  if (!from) return coordinates;
  coordinates.reserve(source.mNumVertices);
  for (unsigned i = 0; i < source.mNumVertices; ++i) {
    const glm::dvec2 uv = place.placed * glm::dvec3(from[i].x, from[i].y, 1);
    *leaves = *leaves || glm::clamp(uv, -kEdge, 1 + kEdge) != uv;
    coordinates.push_back(uv);
  }
  return coordinates;
}

std::vector<std::array<std::uint32_t, 3>> triangles_of(const aiMesh& source, const std::string& path) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(source.mNumFaces);
  for (unsigned i = 0; i < source.mNumFaces; ++i) {
    const aiFace& face = source.mFaces[i];
    if (face.mNumIndices != 3) continue;
    for (int v = 0; v < 3; ++v) {
      if (face.mIndices[v] < source.mNumVertices) continue;
      throw Error(fmt::format("{}: mesh '{}', face {}: index {} is beyond its {} vertices; export the file again", path,
                              one_line(source.mName.C_Str()), i, face.mIndices[v], source.mNumVertices));
    }
    triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  }
  return triangles;
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

double coarseness(const aiMesh& mesh) {
  if (mesh.mNumVertices < 2) return 0;
  glm::dvec3 low = to_glm(mesh.mVertices[0]), high = low;
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
    const glm::dvec3 p = to_glm(mesh.mVertices[i]);
    low = glm::min(low, p), high = glm::max(high, p);
  }
  const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high)), extent = high - low;
  const double far = std::max({farthest.x, farthest.y, farthest.z});
  const double step = std::ldexp(1.0, std::ilogb(far) - (std::numeric_limits<float>::digits - 1));
  return std::isfinite(far) && far > 0 ? step / std::max({extent.x, extent.y, extent.z}) : 0;
}

void add_meshes(const aiScene& file, const NodeNumbers& numbers, const std::vector<TexturePlace>& places,
                const ReadChoice& choice, Document* document) {
  bool has_alpha = false, leaves = false;
  std::size_t coarse = 0, without_coordinates = 0;
  for (unsigned i = 0; i < file.mNumMeshes; ++i) {
    const aiMesh& source = *file.mMeshes[i];
    const TexturePlace place = source.mMaterialIndex < places.size() ? places[source.mMaterialIndex] : TexturePlace();
    DocumentMesh mesh;
    mesh.mesh.name = one_line(source.mName.C_Str());
    mesh.mesh.material = int(source.mMaterialIndex);
    mesh.mesh.positions.reserve(source.mNumVertices);
    for (unsigned v = 0; v < source.mNumVertices; ++v) mesh.mesh.positions.push_back(to_glm(source.mVertices[v]));
    for (unsigned v = 0; v < source.mNumVertices && source.mNormals; ++v)
      mesh.mesh.normals.push_back(to_glm(source.mNormals[v]));
    mesh.mesh.colours = colours_of(source, extension_of(document->name) == "off", &has_alpha);
    bool leaves_here = false;
    mesh.mesh.texture_coordinates = coordinates_of(source, place, &leaves_here);
    const bool has_texture =
        source.mMaterialIndex < places.size() && document->materials[source.mMaterialIndex].texture >= 0;
    without_coordinates += has_texture && mesh.mesh.texture_coordinates.empty();
    leaves = leaves || (leaves_here && !place.repeats);
    mesh.mesh.triangles = triangles_of(source, document->name);
    coarse += coarseness(source) > kCoarse;
    if (source.mNumBones != 0) add_skin(source, numbers, &mesh, document);
    if (mesh.mesh.normals.empty()) {
      add_targets(source, &mesh);
      make_smooth(&mesh, kCreaseDegrees);
    } else {
      mend_normals(&mesh.mesh);
      add_targets(source, &mesh);
    }
    document->meshes.push_back(std::move(mesh));
  }
  auto& remarks = document->remarks;
  if (has_alpha) remarks.emplace_back("vertices that alpha lets shine through are drawn opaque");
  if (leaves && choice.textured)
    remarks.emplace_back("textures that clamp or mirror at their edges are drawn as repeated");
  if (without_coordinates != 0)
    remarks.push_back(
        fmt::format("{} meshes lack the coordinates of their texture: drawn without", without_coordinates));
  if (coarse != 0) {
    remarks.push_back(
        fmt::format("{} mesh{} so far from the origin that its reader (float32) rounds coordinates by more "
                    "than 1/{:.0f} of the size; move it to the origin",
                    coarse, coarse == 1 ? " lies" : "es lie", 1 / kCoarse));
  }
}

}  // namespace halfspace::ref
