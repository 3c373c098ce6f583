// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/distant_lighting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "ref/geometry/geometry.hpp"
#include "ref/geometry/lighting.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::ref {
namespace {

glm::dvec3 centre_of(const Scene& scene) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
  for (const Instance& instance : scene.instances) {
    for (const glm::dvec3& position : scene.meshes[instance.mesh].positions) {
      const glm::dvec3 point(instance.to_world * glm::dvec4(position, 1));
      low = glm::min(low, point), high = glm::max(high, point);
    }
  }
  return (low + high) / 2.0;
}

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 1e-9 ? v / length : glm::dvec3(0);
}

class Builder {
 public:
  Builder(const Scene& scene, const Viewpoint& from, int most_squarings)
      : scene_(scene), most_squarings_(most_squarings) {
    const glm::dvec3 centre = centre_of(scene), to_viewer = from.to_viewer(centre);
    for (const Light& light : lights_of(scene, from)) {
      const Arrival arrival = arrive(light, centre);
      out_.lights.push_back({arrival.to_light, unit_or_zero(arrival.to_light + to_viewer), arrival.intensity});
    }
    for (const Instance& instance : scene.instances) add(instance);
  }

  DistantScene take() { return std::move(out_); }

 private:
  void add(const Instance& instance) {
    const Mesh& mesh = scene_.meshes[instance.mesh];
    const glm::dmat3 turn = normal_matrix(instance.to_world);
    for (const auto& corners : mesh.triangles) {
      DistantTriangle triangle{number(mesh, corners[0]), {}};
      out_.of_face.push_back(std::uint32_t(out_.triangles.size()));
      for (int v = 0; v < 3; ++v) triangle.normals[v] = unit_or_zero(turn * mesh.normals[corners[v]]);
      out_.triangles.push_back(triangle);
      if (!scene_.materials[mesh.material].two_sided) continue;
      for (glm::dvec3& normal : triangle.normals) normal = -normal;
      out_.triangles.push_back(triangle);
    }
  }

  int number(const Mesh& mesh, std::uint32_t vertex) {
    const glm::dvec3 colour = mesh.colours.empty() ? glm::dvec3(1) : mesh.colours[vertex];
    const auto [at, is_new] =
        numbers_.try_emplace({mesh.material, colour.r, colour.g, colour.b}, int(out_.materials.size()));
    if (is_new) out_.materials.push_back(material(scene_.materials[mesh.material], colour));
    return at->second;
  }

  DistantMaterial material(const Material& in, const glm::dvec3& colour) const {
    const int k = squarings(in.shininess, most_squarings_);
    if (in.unlit) {
      const DistantMaterial::Reflection none{glm::dvec3(0), glm::dvec3(0)};
      return {255.0 * in.diffuse * colour, 0, std::vector<DistantMaterial::Reflection>(out_.lights.size(), none)};
    }
    DistantMaterial out{255.0 * (in.emission + scene_.ambient * in.ambient * colour), std::max(k, 0), {}};
    for (const DistantLight& light : out_.lights) {
      out.reflections.push_back({255.0 * light.intensity * in.diffuse * colour,
                                 k < 0 ? glm::dvec3(0) : 255.0 * light.intensity * in.specular});
    }
    return out;
  }

  const Scene& scene_;
  int most_squarings_;
  std::map<std::tuple<int, double, double, double>, int> numbers_;
  DistantScene out_;
};

}  // namespace

int squarings(double shininess, int most) {
  if (!(shininess > 0) || most < 0) return -1;
  return int(std::clamp(std::round(std::log2(shininess)), 0.0, double(most)));
}

DistantScene distant_scene(const Scene& scene, const Viewpoint& from, int most_squarings) {
  return Builder(scene, from, most_squarings).take();
}

glm::dvec3 distant_colour(const DistantMaterial& material, const std::vector<DistantLight>& lights,
                          const glm::dvec3& n) {
  const double length = glm::length(n);
  glm::dvec3 total = material.base;
  for (std::size_t i = 0; length > 0 && i < lights.size(); ++i) {
    const double diffuse = glm::dot(n, lights[i].to_light) / length;
    if (diffuse <= 0) continue;
    const double cosine = std::max(glm::dot(n, lights[i].half) / length, 0.0);
    total += material.reflections[i].diffuse * diffuse;
    total += material.reflections[i].specular * std::pow(cosine, std::ldexp(1.0, material.squarings));
  }
  return glm::clamp(total, 0.0, 255.0);
}

SnappedList distantly_lit(SnappedList list, const Geometry& geometry, int most_squarings) {
  const DistantScene scene = distant_scene(geometry.scene(), geometry.viewpoint(), most_squarings);
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    const int material = scene.triangles[scene.of_face[geometry.positions().face[k] - 1]].material;
    const std::array<glm::dvec3, 3> normals = geometry.normals(k);
    for (int v = 0; v < 3; ++v) {
      const glm::dvec3 colour = distant_colour(scene.materials[material], scene.lights, normals[v]);
      for (int c = 0; c < 3; ++c) list.triangles[k].rgb[v][c] = snapped_colour(colour[c], list.format.colour_bits);
    }
  }
  return list;
}

}  // namespace halfspace::ref
