// SPDX-License-Identifier: Apache-2.0
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "ref/error.hpp"
#include "ref/scene/assimp/assimp_parts.hpp"

namespace halfspace::ref {
namespace {

namespace fs = std::filesystem;

// Assimp turns all coordinates so that v goes up, and pictures begin with their top row.
constexpr bool kTopRowIsAtOne = true;

Texture raw_texture(const aiTexture& source, const std::string& name) {
  Texture texture{name, int(source.mWidth), int(source.mHeight), {}};
  for (unsigned y = source.mHeight; y-- > 0;) {
    for (unsigned x = 0; x < source.mWidth; ++x) {
      const aiTexel& t = source.pcData[std::size_t(y) * source.mWidth + x];
      texture.texels.push_back({t.r, t.g, t.b});
    }
  }
  return texture;
}

Texture embedded_texture(const aiTexture& source, const std::string& name) {
  if (source.mHeight != 0) return raw_texture(source, name);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(source.pcData);
  return read_texture(name, std::vector<std::uint8_t>(bytes, bytes + source.mWidth), kTopRowIsAtOne);
}

// Exporters write paths of their own machines: what counts then is the name of the file.
std::string find_file(const std::string& scene, std::string named) {
  std::replace(named.begin(), named.end(), '\\', '/');
  const fs::path folder = fs::path(scene).parent_path(), path(named);
  for (const fs::path& candidate : {folder / path, folder / path.filename()}) {
    std::error_code error;
    if (fs::is_regular_file(candidate, error)) return candidate.string();
  }
  throw Error(
      fmt::format("{}: its texture '{}' is not there; put it beside the file, or leave textures out", scene, named));
}

}  // namespace

void add_textures(const aiScene& file, Document* document) {
  const std::string& path = document->name;
  std::map<std::string, int> numbers;
  for (unsigned i = 0; i < file.mNumMaterials; ++i) {
    aiString name;
    const aiMaterial& material = *file.mMaterials[i];
    if (material.GetTexture(aiTextureType_BASE_COLOR, 0, &name) != AI_SUCCESS &&
        material.GetTexture(aiTextureType_DIFFUSE, 0, &name) != AI_SUCCESS) {
      continue;
    }
    const auto [at, is_new] = numbers.try_emplace(name.C_Str(), int(document->textures.size()));
    if (is_new) {
      const aiTexture* const embedded = file.GetEmbeddedTexture(name.C_Str());
      document->textures.push_back(embedded ? embedded_texture(*embedded, path + ": texture " + name.C_Str())
                                            : read_texture(find_file(path, name.C_Str()), kTopRowIsAtOne));
    }
    document->materials[i].texture = at->second;
  }
}

}  // namespace halfspace::ref
