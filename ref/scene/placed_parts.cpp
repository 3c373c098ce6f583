// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/placed_parts.hpp"

#include <algorithm>
#include <cmath>

#include "ref/scene/box.hpp"

namespace halfspace::ref {
namespace {

constexpr double kMostAmbient = 0.4;  // more would leave little for the other lights

bool usable(const glm::dvec3& direction) {
  const double length = glm::length(direction);
  return std::isfinite(length) && length > 1e-9;
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

std::optional<Camera> placed_camera(const DocumentCamera& source, const Pose& pose) {
  const glm::dmat4& to_world = pose.to_world(source.node);
  Camera camera = source.camera;
  camera.position = to_world * glm::dvec4(camera.position, 1);
  camera.forward = glm::dmat3(to_world) * camera.forward;
  camera.up = glm::dmat3(to_world) * camera.up;
  if (!usable(camera.forward) || !usable(camera.up) || !std::isfinite(glm::length(camera.position)))
    return std::nullopt;
  // The node may carry the scale of the file's unit, as Collada's root does.
  const double scale = glm::length(camera.forward) / glm::length(source.camera.forward);
  camera.near *= scale;
  camera.far *= scale;
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

void add_placed_lights(const Document& document, const Pose& pose, Scene* scene) {
  for (const DocumentLight& source : document.lights) {
    const glm::dmat4& to_world = pose.to_world(source.node);
    Light light = source.light;
    light.position = to_world * glm::dvec4(light.position, 1);
    const glm::dvec3 direction = glm::dmat3(to_world) * light.direction;
    light.direction = usable(direction) ? glm::normalize(direction) : glm::dvec3(0, 0, -1);
    if (std::isfinite(glm::length(light.position))) scene->lights.push_back(light);
  }
  if (document.ambient) scene->ambient = glm::min(*document.ambient, glm::dvec3(kMostAmbient));
  if (!scene->framing.empty() && !scene->lights.empty()) expose(scene);
}

}  // namespace halfspace::ref
