// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/lighting.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::ref {

glm::dvec3 placed_normal(const Mesh& mesh, std::uint32_t vertex, const glm::dmat3& turn, bool back) {
  glm::dvec3 normal = turn * mesh.normals[vertex];
  const double length = glm::length(normal);
  if (length > 0) normal /= length;
  return back ? -normal : normal;
}

SurfacePoint placed_vertex(const Mesh& mesh, std::uint32_t vertex, const glm::dmat4& to_world, const glm::dmat3& turn,
                           bool back, const Viewpoint& viewpoint) {
  const glm::dvec3 world(to_world * glm::dvec4(mesh.positions[vertex], 1));
  return {world, placed_normal(mesh, vertex, turn, back), viewpoint.to_viewer(world),
          mesh.colours.empty() ? glm::dvec3(1) : mesh.colours[vertex]};
}

Arrival arrive(const Light& light, const glm::dvec3& point) {
  if (light.kind == Light::Kind::kDirectional) return {-light.direction, light.colour};
  const glm::dvec3 way = light.position - point;
  const double d = std::max(glm::length(way), 1e-9);
  const glm::dvec3 to_light = way / d;
  const double divisor = light.attenuation.x + light.attenuation.y * d + light.attenuation.z * d * d;
  double factor = divisor > 0 ? 1 / divisor : 1;
  if (light.kind == Light::Kind::kSpot) {
    const double cosine = glm::dot(-to_light, light.direction);
    const double width = std::max(light.cos_inner - light.cos_outer, 1e-9);
    factor *= std::clamp((cosine - light.cos_outer) / width, 0.0, 1.0);
  }
  return {to_light, light.colour * factor};
}

std::vector<Light> lights_of(const Scene& scene, const Viewpoint& from) {
  if (!scene.lights.empty()) return scene.lights;
  Light headlight;
  headlight.direction = glm::normalize(from.forward + 0.4 * from.right - 0.65 * from.up);
  headlight.colour = glm::dvec3(0.8);
  return {headlight};
}

glm::dvec3 phong(const SurfacePoint& at, const Material& material, const glm::dvec3& ambient,
                 const std::vector<Light>& lights) {
  if (material.unlit) return glm::clamp(255.0 * material.diffuse * at.colour, 0.0, 255.0);
  glm::dvec3 total = material.emission + ambient * material.ambient * at.colour;
  for (const Light& light : lights) {
    const Arrival arrival = arrive(light, at.position);
    const double diffuse = glm::dot(arrival.to_light, at.normal);
    if (diffuse <= 0) continue;
    total += arrival.intensity * material.diffuse * at.colour * diffuse;
    const glm::dvec3 half = arrival.to_light + at.to_viewer;
    const double length = glm::length(half);
    if (length < 1e-9) continue;  // the light shines from behind, straight at the viewer
    const double cosine = std::max(glm::dot(half, at.normal) / length, 0.0);
    total += arrival.intensity * material.specular * std::pow(cosine, material.shininess);
  }
  return glm::clamp(255.0 * total, 0.0, 255.0);
}

}  // namespace halfspace::ref
