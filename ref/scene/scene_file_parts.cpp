// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/scene_file_parts.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::ref {
namespace {

constexpr double kMostAmbient = 0.4;  // more would leave little for the other lights

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

bool usable(const glm::dvec3& direction) {
  const double length = glm::length(direction);
  return std::isfinite(length) && length > 1e-9;
}

// Half of the size of the view at distance 1; 0 for an angle that is none. Assimp's Collada importer turns
// the angle of a camera that has none, 45 degrees, into radians twice: 0.0137.
double half_size(double angle) { return angle > 0.0138 && angle < 3.1 ? std::tan(angle / 2) : 0; }

struct Box {
  glm::dvec3 low, high;
};

Box box_of(const std::vector<glm::dvec3>& points) {
  Box box{points.front(), points.front()};
  for (const glm::dvec3& p : points) box = {glm::min(box.low, p), glm::max(box.high, p)};
  return box;
}

double strength(const Light& light, const glm::dvec3& point) {
  double divisor = 1;
  if (light.kind != Light::Kind::kDirectional) {
    const double d = glm::distance(light.position, point);
    divisor = light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d;
    if (!(divisor > 0)) divisor = 1;
  }
  return std::max({light.colour.r, light.colour.g, light.colour.b}) / divisor;
}

void expose(Scene* scene) {
  const Box box = box_of(scene->framing);
  double total = 0;
  for (const Light& light : scene->lights) total += strength(light, (box.low + box.high) / 2.0);
  if (!(total > 0) || !std::isfinite(total)) return scene->lights.clear();
  for (Light& light : scene->lights) light.colour *= std::clamp(total, 0.25, 1.0) / total;
}

}  // namespace

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

std::optional<Camera> camera_of(const aiCamera& source, const Pose& pose, const std::string& extension) {
  const glm::dmat4 to_world = pose.to_world(source.mName.C_Str());
  const bool gltf = extension == "gltf" || extension == "glb";
  Camera camera;
  // Assimp's importer of glTF sets the position to what the node is moved by, which is in its matrix.
  camera.position = to_world * glm::dvec4(gltf ? glm::dvec3(0) : to_glm(source.mPosition), 1);
  camera.forward = glm::dmat3(to_world) * to_glm(source.mLookAt);
  camera.up = glm::dmat3(to_world) * to_glm(source.mUp);
  if (!usable(camera.forward) || !usable(camera.up) || !std::isfinite(glm::length(camera.position)))
    return std::nullopt;
  const double aspect = source.mAspect > 0 ? source.mAspect : 0;
  if (source.mOrthographicWidth > 0) {
    camera.orthographic = true;
    camera.half_width = source.mOrthographicWidth;
    camera.half_height = aspect > 0 ? camera.half_width / aspect : 0;
  } else if (gltf) {
    // Assimp's importer multiplies the vertical angle by the aspect ratio, if there is one.
    camera.half_height = half_size(aspect > 0 ? source.mHorizontalFOV / aspect : source.mHorizontalFOV);
  } else {
    camera.half_width = half_size(source.mHorizontalFOV);
    camera.half_height = aspect > 0 ? camera.half_width / aspect : 0;
  }
  if (source.mClipPlaneNear > 0 && source.mClipPlaneFar > source.mClipPlaneNear) {
    // The node may carry the scale of the file's unit, as Collada's root does.
    const double scale = glm::length(camera.forward) / glm::length(to_glm(source.mLookAt));
    camera.near = scale * source.mClipPlaneNear;
    if (std::isfinite(source.mClipPlaneFar)) camera.far = scale * source.mClipPlaneFar;
  }
  return camera;
}

bool sees(const Camera& camera, const std::vector<glm::dvec3>& points) {
  if (points.empty()) return false;
  const Box box = box_of(points);
  if (camera.position == glm::clamp(camera.position, box.low, box.high)) return true;
  const glm::dvec3 forward = glm::normalize(camera.forward);
  const double half_size = std::max({camera.half_width, camera.half_height, 0.3});
  return std::any_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
    const double ahead = glm::dot(point - camera.position, forward);
    const double aside = glm::length(point - camera.position - ahead * forward);
    return ahead > 0 && (camera.far == 0 || ahead < camera.far) &&
           aside < (camera.orthographic ? 1 : ahead) * half_size;
  });
}

void add_lights(const aiScene& file, const Pose& pose, Scene* scene) {
  glm::dvec3 ambient(0);
  for (unsigned i = 0; i < file.mNumLights; ++i) {
    const aiLight& source = *file.mLights[i];
    const glm::dmat4 to_world = pose.to_world(source.mName.C_Str());
    Light light;
    light.colour = sane_colour(to_glm(source.mColorDiffuse));
    light.position = to_world * glm::dvec4(to_glm(source.mPosition), 1);
    light.attenuation = {source.mAttenuationConstant, source.mAttenuationLinear, source.mAttenuationQuadratic};
    const glm::dvec3 direction = glm::dmat3(to_world) * to_glm(source.mDirection);
    light.direction = usable(direction) ? glm::normalize(direction) : glm::dvec3(0, 0, -1);
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
    if (!is_black(light.colour) && std::isfinite(glm::length(light.position))) scene->lights.push_back(light);
  }
  if (!is_black(ambient)) scene->ambient = glm::min(ambient, glm::dvec3(kMostAmbient));
  if (!scene->framing.empty()) expose(scene);
}

}  // namespace halfspace::ref
