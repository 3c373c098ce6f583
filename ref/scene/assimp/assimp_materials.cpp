// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/assimp_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/error.hpp"
#include "ref/scene/assimp/assimp_parts.hpp"
#include "ref/scene/assimp/assimp_textures.hpp"

namespace halfspace::ref {
namespace {

// A map of a material: its picture, and how it lies.
struct Map {
  std::string file;  // empty: none
  TexturePlace place;
};

struct UndrawnMap {
  aiTextureType type;
  const char* name;
};
constexpr UndrawnMap kUndrawn[] = {
    {aiTextureType_SPECULAR, "specular"},    {aiTextureType_SHININESS, "specular"},
    {aiTextureType_HEIGHT, "bump"},          {aiTextureType_NORMALS, "normal"},
    {aiTextureType_NORMAL_CAMERA, "normal"}, {aiTextureType_DISPLACEMENT, "displacement"},
    {aiTextureType_OPACITY, "opacity"},      {aiTextureType_REFLECTION, "reflection"},
    {aiTextureType_LIGHTMAP, "light"},       {aiTextureType_AMBIENT_OCCLUSION, "occlusion"},
    {aiTextureType_METALNESS, "metalness"},  {aiTextureType_DIFFUSE_ROUGHNESS, "roughness"},
};

// What importers write below 0 is a colour that is not set.
glm::dvec3 colour_of(const aiMaterial& source, const char* key, unsigned type, unsigned index,
                     const glm::dvec3& absent) {
  aiColor3D colour;
  if (source.Get(key, type, index, colour) != AI_SUCCESS || colour.r < 0 || colour.g < 0 || colour.b < 0) return absent;
  return sane_colour(to_glm(colour));
}

Material material_of(const aiMaterial& source) {
  Material material;
  material.diffuse = colour_of(source, AI_MATKEY_COLOR_DIFFUSE, glm::dvec3(0.8));
  // Most exporters write black for "not set", which would leave the shadow side without form.
  material.ambient = colour_of(source, AI_MATKEY_COLOR_AMBIENT, glm::dvec3(0));
  if (is_black(material.ambient)) material.ambient = material.diffuse;
  material.specular = colour_of(source, AI_MATKEY_COLOR_SPECULAR, glm::dvec3(0));
  material.emission = colour_of(source, AI_MATKEY_COLOR_EMISSIVE, glm::dvec3(0));
  float number = 1;
  if (source.Get(AI_MATKEY_SHININESS_STRENGTH, number) == AI_SUCCESS && number >= 0) material.specular *= number;
  number = 0;
  source.Get(AI_MATKEY_SHININESS, number);
  material.shininess = number;
  if (!(number > 0)) material.specular = glm::dvec3(0);  // x^0 would shine everywhere
  int two_sided = 0;
  source.Get(AI_MATKEY_TWOSIDED, two_sided);
  material.two_sided = two_sided != 0;
  return material;
}

// As Assimp's own step does it: shifted, then turned and scaled about the middle.
glm::dmat3 matrix_of(const aiUVTransform& t) {
  const auto shift = [](double u, double v) { return glm::dmat3(1, 0, 0, 0, 1, 0, u, v, 1); };
  const double c = std::cos(double(t.mRotation)), s = std::sin(double(t.mRotation));
  const glm::dmat3 scale(t.mScaling.x, 0, 0, 0, t.mScaling.y, 0, 0, 0, 1), turn(c, s, 0, -s, c, 0, 0, 0, 1);
  return shift(0.5, 0.5) * scale * turn * shift(-0.5, -0.5) * shift(t.mTranslation.x, t.mTranslation.y);
}

Map map_of(const aiMaterial& source, aiTextureType type) {
  Map map;
  aiString file;
  unsigned coordinates = 0;
  aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
  if (source.GetTexture(type, 0, &file, nullptr, &coordinates, nullptr, nullptr, modes) != AI_SUCCESS) return map;
  map.file = file.C_Str();
  map.place.coordinates = coordinates;
  map.place.repeats = modes[0] == aiTextureMapMode_Wrap && modes[1] == aiTextureMapMode_Wrap;
  aiUVTransform transform;
  if (source.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == AI_SUCCESS) map.place.placed = matrix_of(transform);
  return map;
}

Map map_of(const MtlMap& source) {
  Map map;
  map.file = source.file;
  map.place.placed = glm::dmat3(source.scale.x, 0, 0, 0, source.scale.y, 0, source.offset.x, source.offset.y, 1);
  map.place.repeats = source.repeats;
  return map;
}

class Materials {
 public:
  Materials(const aiScene& file, const ReadChoice& choice, Document* document)
      : choice_(choice), document_(*document), textures_(file, document) {}

  TexturePlace add(const aiMaterial& source, const MtlMaps* mtl, bool is_used) {
    Material material = material_of(source);
    Map base = mtl ? map_of(mtl->diffuse) : map_of(source, aiTextureType_BASE_COLOR);
    if (base.file.empty() && !mtl) base = map_of(source, aiTextureType_DIFFUSE);
    Map emission = mtl ? map_of(mtl->emission) : map_of(source, aiTextureType_EMISSIVE);
    if (is_used) {
      if (!emission.file.empty() && !is_black(material.emission)) emit(emission, &base, &material);
      say_what_is_not_drawn(source, base);
      if (choice_.textured && !base.file.empty()) take(base, &material);
    }
    document_.materials.push_back(material);
    return base.place;
  }

 private:
  void remark(const std::string& sentence) {
    auto& all = document_.remarks;
    if (std::find(all.begin(), all.end(), sentence) == all.end()) all.push_back(sentence);
  }

  void take(const Map& base, Material* material) {
    material->texture = textures_.in_document(base.file);
    if (!is_black(material->diffuse) && !is_black(material->emission)) {
      remark("what a textured material emits is multiplied by its texture");
    }
  }

  // Emission is factor times map. A map that is not of one colour would be a second picture of the surface: it is one
  // where nothing of the surface is lit, and else it counts by its mean.
  void emit(const Map& map, Map* base, Material* material) {
    if (choice_.textured && is_black(material->diffuse)) {
      *base = map;
      return;
    }
    try {
      const MeanColour mean = textures_.mean(map.file);
      if (!mean.is_uniform) remark("what emits light by a picture emits its mean colour everywhere");
      material->emission *= mean.colour;
    } catch (const Error&) {
      if (choice_.textured) throw;
      remark("emission by a picture that is not there, or cannot be read, is left out");
      material->emission = glm::dvec3(0);
    }
  }

  void say_what_is_not_drawn(const aiMaterial& source, const Map& base) {
    float opacity = 1;
    if (source.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS && opacity < 1) {
      remark("transparent materials are drawn opaque");
    }
    if (!choice_.textured) return;
    for (const UndrawnMap& map : kUndrawn) {
      const std::string file = map_of(source, map.type).file;
      if (!file.empty() && file != base.file) remark(fmt::format("{} maps are left out", map.name));
    }
  }

  const ReadChoice& choice_;
  Document& document_;
  AssimpTextures textures_;
};

}  // namespace

bool is_black(const glm::dvec3& c) { return c.r <= 0 && c.g <= 0 && c.b <= 0; }

glm::dvec3 sane_colour(const glm::dvec3& c) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(c[i])) return glm::dvec3(0);
  }
  return glm::max(c, glm::dvec3(0));
}

std::vector<TexturePlace> add_materials(const aiScene& file, const std::map<std::string, MtlMaps>& mtl,
                                        const ReadChoice& choice, Document* document) {
  std::vector<char> is_used(file.mNumMaterials, false);
  for (unsigned i = 0; i < file.mNumMeshes; ++i) {
    if (file.mMeshes[i]->mMaterialIndex < file.mNumMaterials) is_used[file.mMeshes[i]->mMaterialIndex] = true;
  }
  Materials materials(file, choice, document);
  std::size_t without_library = 0;
  std::vector<TexturePlace> places;
  for (unsigned i = 0; i < file.mNumMaterials; ++i) {
    const aiMaterial& source = *file.mMaterials[i];
    aiString name;
    source.Get(AI_MATKEY_NAME, name);
    const auto of_library = mtl.find(name.C_Str());
    without_library +=
        is_used[i] && !mtl.empty() && of_library == mtl.end() && name != aiString(AI_DEFAULT_MATERIAL_NAME);
    places.push_back(materials.add(source, of_library == mtl.end() ? nullptr : &of_library->second, is_used[i] != 0));
  }
  if (without_library == 1) document->remarks.emplace_back("1 material is in no library, and is drawn grey");
  if (without_library > 1) {
    document->remarks.push_back(fmt::format("{} materials are in no library, and are drawn grey", without_library));
  }
  return places;
}

}  // namespace halfspace::ref
