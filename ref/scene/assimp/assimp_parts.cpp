// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/assimp_parts.hpp"

#include <algorithm>
#include <cmath>

#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

bool is_black(const glm::dvec3& c) { return c.r <= 0 && c.g <= 0 && c.b <= 0; }

glm::dvec3 sane_colour(const glm::dvec3& c) {
  for (int i = 0; i < 3; ++i) {
    if (!std::isfinite(c[i])) return glm::dvec3(0);
  }
  return glm::max(c, glm::dvec3(0));
}

glm::dvec3 colour_of(const aiMaterial& source, const char* key, unsigned type, unsigned index,
                     const glm::dvec3& absent) {
  aiColor3D colour;
  if (source.Get(key, type, index, colour) != AI_SUCCESS) return absent;
  return sane_colour(to_glm(colour));
}

// Half of the size of the view at distance 1; 0 for an angle that is none. Assimp's Collada importer turns
// the angle of a camera that has none, 45 degrees, into radians twice: 0.0137.
double half_size(double angle) { return angle > 0.0138 && angle < 3.1 ? std::tan(angle / 2) : 0; }

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

Camera camera_of(const aiCamera& source) {
  Camera camera;
  camera.position = to_glm(source.mPosition);
  camera.forward = to_glm(source.mLookAt);
  camera.up = to_glm(source.mUp);
  const double aspect = source.mAspect > 0 ? source.mAspect : 0;
  if (source.mOrthographicWidth > 0) {
    camera.orthographic = true;
    camera.half_width = source.mOrthographicWidth;
    camera.half_height = aspect > 0 ? camera.half_width / aspect : 0;
  } else {
    camera.half_width = half_size(source.mHorizontalFOV);
    camera.half_height = aspect > 0 ? camera.half_width / aspect : 0;
  }
  if (source.mClipPlaneNear > 0 && source.mClipPlaneFar > source.mClipPlaneNear) {
    camera.near = source.mClipPlaneNear;
    if (std::isfinite(source.mClipPlaneFar)) camera.far = source.mClipPlaneFar;
  }
  return camera;
}

int number_of(const aiString& name, const NodeNumbers& numbers) {
  const auto found = numbers.find(name.C_Str());
  return found == numbers.end() ? -1 : found->second;
}

}  // namespace

void add_materials(const aiScene& file, Document* document) {
  for (unsigned i = 0; i < file.mNumMaterials; ++i) document->materials.push_back(material_of(*file.mMaterials[i]));
}

void add_cameras(const aiScene& file, const NodeNumbers& numbers, Document* document) {
  const std::string extension = extension_of(document->name);
  const bool is_doubtful = extension == "3ds" || extension == "ase";  // their importers turn cameras the wrong way
  for (unsigned i = 0; i < file.mNumCameras; ++i) {
    const aiCamera& camera = *file.mCameras[i];
    document->cameras.push_back(
        {one_line(camera.mName.C_Str()), number_of(camera.mName, numbers), camera_of(camera), is_doubtful});
  }
}

void add_lights(const aiScene& file, const NodeNumbers& numbers, Document* document) {
  glm::dvec3 ambient(0);
  for (unsigned i = 0; i < file.mNumLights; ++i) {
    const aiLight& source = *file.mLights[i];
    Light light;
    light.colour = sane_colour(to_glm(source.mColorDiffuse));
    light.position = to_glm(source.mPosition);
    light.attenuation = {source.mAttenuationConstant, source.mAttenuationLinear, source.mAttenuationQuadratic};
    light.direction = to_glm(source.mDirection);
    light.cos_inner = std::cos(source.mAngleInnerCone / 2.0);
    light.cos_outer = std::cos(source.mAngleOuterCone / 2.0);
    switch (source.mType) {
      case aiLightSource_AMBIENT:
        ambient += glm::max(sane_colour(to_glm(source.mColorAmbient)), light.colour);
        continue;
      case aiLightSource_DIRECTIONAL: light.kind = Light::Kind::kDirectional; break;
      case aiLightSource_SPOT: light.kind = Light::Kind::kSpot; break;
      default: light.kind = Light::Kind::kPoint;  // an area light is a point from afar
    }
    if (!is_black(light.colour)) document->lights.push_back({number_of(source.mName, numbers), light});
  }
  if (!is_black(ambient)) document->ambient = ambient;
}

}  // namespace halfspace::ref
