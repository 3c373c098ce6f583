// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/assimp_textures.hpp"

#include <assimp/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"

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
  if (source.mWidth == 0 || !source.pcData) {
    throw Error(fmt::format("{}: the texture has no bytes; export the scene again", name));
  }
  if (source.mHeight != 0) return raw_texture(source, name);
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(source.pcData);
  return read_texture(name, std::vector<std::uint8_t>(bytes, bytes + source.mWidth), kTopRowIsAtOne);
}

std::string lower(std::string text) {
  for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// A file of the folder whose name differs in the case of letters alone; empty: there is none.
std::string in_other_case(const fs::path& folder, const std::string& name) {
  std::error_code error;
  for (fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code ignored;
    if (lower(entry->path().filename().string()) == lower(name) && entry->is_regular_file(ignored))
      return (folder / entry->path().filename()).string();
  }
  return "";
}

// Exporters write paths of their own machines: what counts then is the name of the file. Some leave spaces behind it,
// some write it in capitals.
std::string find_file(const std::string& scene, const std::string& as_it_stands) {
  std::string slashed = as_it_stands, trimmed;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  trimmed = slashed.substr(0, slashed.find_last_not_of(" \t\r\n") + 1);
  const fs::path folder = fs::path(scene).parent_path();
  for (const fs::path path : {slashed, trimmed}) {
    for (const fs::path& candidate : {folder / path, folder / path.filename()}) {
      std::error_code error;
      if (!path.empty() && fs::is_regular_file(candidate, error)) return candidate.string();
    }
  }
  const std::string other = in_other_case(folder, fs::path(trimmed).filename().string());
  if (!other.empty()) return other;
  throw Error(fmt::format("{}: its texture '{}' is not there; put it beside the file, or leave textures out", scene,
                          one_line(trimmed)));
}

}  // namespace

Texture AssimpTextures::read(const std::string& name) const {
  const std::string& path = document_.name;
  const aiTexture* const embedded = file_.GetEmbeddedTexture(name.c_str());
  return embedded ? embedded_texture(*embedded, path + ": texture " + one_line(name))
                  : read_texture(find_file(path, name), kTopRowIsAtOne);
}

int AssimpTextures::in_document(const std::string& name) {
  const auto [at, is_new] = numbers_.try_emplace(name, int(document_.textures.size()));
  if (is_new) document_.textures.push_back(read(name));
  return at->second;
}

MeanColour AssimpTextures::mean(const std::string& name) {
  const auto [at, is_new] = means_.try_emplace(name);
  if (is_new) {
    const auto held = numbers_.find(name);
    at->second = mean_colour(held == numbers_.end() ? read(name) : document_.textures[std::size_t(held->second)]);
  }
  return at->second;
}

}  // namespace halfspace::ref
