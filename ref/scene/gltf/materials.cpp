// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halfspace::ref::gltf {
namespace {

using tinygltf::TextureInfo;
using tinygltf::Value;

const Value* extension(const tinygltf::ExtensionMap& of, const char* name) {
  const auto found = of.find(name);
  return found == of.end() ? nullptr : &found->second;
}

double number(const Value& object, const char* name, double absent) {
  return object.IsObject() && object.Has(name) ? object.Get(name).GetNumberAsDouble() : absent;
}

// Of a list, whose length the schema holds.
double number(const Value& object, const char* name, int index, double absent) {
  return object.IsObject() && object.Has(name) ? object.Get(name).Get(index).GetNumberAsDouble() : absent;
}

glm::dvec4 colour(const Value& object, const char* name) {
  glm::dvec4 of(1);
  for (int i = 0; i < 4; ++i) of[i] = std::min(number(object, name, i, 1), 1.0);
  return of;
}

TextureInfo info_of(const Value& object) {
  TextureInfo info;
  info.index = int(number(object, "index", -1)), info.texCoord = int(number(object, "texCoord", 0));
  if (object.IsObject() && object.Has("extensions")) {
    const Value& extensions = object.Get("extensions");
    if (extensions.Has("KHR_texture_transform")) {
      info.extensions["KHR_texture_transform"] = extensions.Get("KHR_texture_transform");
    }
  }
  return info;
}

// Scaled, turned counter-clockwise as seen (v goes down), shifted. Then v goes up, as of the other formats.
glm::dmat3 placed(const Value* transform) {
  glm::dmat3 to(1);
  if (transform) {
    const double angle = number(*transform, "rotation", 0), c = std::cos(angle), s = std::sin(angle);
    const double x = number(*transform, "scale", 0, 1), y = number(*transform, "scale", 1, 1);
    to[0] = {c * x, -s * x, 0};
    to[1] = {s * y, c * y, 0};
    to[2] = {number(*transform, "offset", 0, 0), number(*transform, "offset", 1, 0), 1};
  }
  return glm::dmat3(1, 0, 0, 0, -1, 0, 0, 1, 1) * to;
}

// As Assimp's importer has it. Without anything specular it counts for nothing.
double shininess_of(double roughness) { return (1 - roughness) * (1 - roughness) * 1000; }

bool is_black(const glm::dvec3& c) { return c == glm::dvec3(0); }

}  // namespace

const Surface& Materials::of(int material) {
  const auto [at, is_new] = surfaces_.try_emplace(material);
  if (is_new) {
    const tinygltf::Material none;
    at->second = read(material < 0 ? none : file_.model.materials[std::size_t(material)]);
  }
  return at->second;
}

void Materials::take_picture(const TextureInfo& info, Material* material, Surface* surface) {
  const int picture = pictures_.of_texture(info.index);
  if (picture < 0) return;
  const Value* const transform = extension(info.extensions, "KHR_texture_transform");
  surface->coordinates = transform ? int(number(*transform, "texCoord", info.texCoord)) : info.texCoord;
  surface->placed = placed(transform);
  const int sampler = file_.model.textures[std::size_t(info.index)].sampler;
  if (sampler >= 0) {
    const tinygltf::Sampler& of = file_.model.samplers[std::size_t(sampler)];
    surface->repeats = of.wrapS == TINYGLTF_TEXTURE_WRAP_REPEAT && of.wrapT == TINYGLTF_TEXTURE_WRAP_REPEAT;
  }
  if (file_.choice.textured) material->texture = pictures_.in_document(picture);
}

// Emission is factor times map. A map that is not of one colour would be a second picture of the surface: it is one
// where there is no other and nothing of the surface is lit, and else it counts by its mean.
glm::dvec3 Materials::emission(const tinygltf::Material& source, Material* material, Surface* surface) {
  glm::dvec3 emission(0);
  for (int i = 0; i < 3 && i < int(source.emissiveFactor.size()); ++i)
    emission[i] = source.emissiveFactor[std::size_t(i)];
  if (const Value* strength = extension(source.extensions, "KHR_materials_emissive_strength")) {
    emission *= number(*strength, "emissiveStrength", 1);
  }
  const TextureInfo& info = source.emissiveTexture;
  const int picture = is_black(emission) || info.index < 0 ? -1 : pictures_.of_texture(info.index);
  if (picture < 0) return emission;
  if (file_.choice.textured && is_black(material->diffuse)) {
    take_picture(info, material, surface);
    return emission;
  }
  try {
    const Pictures::Mean mean = pictures_.mean(picture);
    if (!mean.is_uniform) file_.remark("what emits light by a picture emits its mean colour everywhere");
    return emission * mean.colour;
  } catch (const Error&) {
    if (file_.choice.textured) throw;
    file_.remark("emission by a picture that is not there, or cannot be read, is left out");
    return glm::dvec3(0);
  }
}

void Materials::read_alpha(const tinygltf::Material& source, double alpha, bool has_picture, Surface* surface) {
  if (source.alphaMode == "OPAQUE") return;
  if (source.alphaMode != "MASK" && source.alphaMode != "BLEND") {
    file_.refuse(fmt::format("cannot be read as a mesh (an alphaMode is '{}')", name_of(source.alphaMode)));
  }
  const bool masks = source.alphaMode == "MASK";
  surface->has_alpha = true;
  surface->is_drawn = masks ? alpha >= source.alphaCutoff : alpha > 0;
  if (!surface->is_drawn) return;
  if (masks && has_picture) file_.remark("what alpha cuts out (MASK) is drawn opaque");
  if (!masks && (has_picture || alpha < 1)) file_.remark("what alpha lets shine through (BLEND) is drawn opaque");
}

Surface Materials::read(const tinygltf::Material& source) {
  Material material;
  Surface surface;
  glm::dvec4 base(1);
  for (int i = 0; i < 4; ++i) base[i] = std::min(source.pbrMetallicRoughness.baseColorFactor[std::size_t(i)], 1.0);
  TextureInfo info = source.pbrMetallicRoughness.baseColorTexture;
  material.shininess = shininess_of(source.pbrMetallicRoughness.roughnessFactor);
  if (const Value* glossy = extension(source.extensions, "KHR_materials_pbrSpecularGlossiness")) {
    base = colour(*glossy, "diffuseFactor");
    material.specular = colour(*glossy, "specularFactor");
    material.shininess = 1000 * number(*glossy, "glossinessFactor", 1);
    info = glossy->IsObject() && glossy->Has("diffuseTexture") ? info_of(glossy->Get("diffuseTexture")) : TextureInfo();
  }
  material.ambient = material.diffuse = base;
  if (!(material.shininess > 0)) material.specular = glm::dvec3(0);  // x^0 would shine everywhere
  material.two_sided = source.doubleSided;
  material.unlit = extension(source.extensions, "KHR_materials_unlit") != nullptr;
  if (info.index >= 0) take_picture(info, &material, &surface);
  if (!material.unlit) material.emission = emission(source, &material, &surface);
  if (material.texture >= 0 && !is_black(material.diffuse) && !is_black(material.emission)) {
    file_.remark("what a textured material emits is multiplied by its texture");
  }
  const int other_maps[] = {source.normalTexture.index, source.occlusionTexture.index,
                            source.pbrMetallicRoughness.metallicRoughnessTexture.index};
  if (std::any_of(std::begin(other_maps), std::end(other_maps), [](int map) { return map >= 0; })) {
    file_.remark("maps of normals, occlusion, metal and roughness are left out");
  }
  read_alpha(source, base.a, info.index >= 0, &surface);
  surface.material = int(file_.document.materials.size());
  file_.document.materials.push_back(material);
  return surface;
}

}  // namespace halfspace::ref::gltf
