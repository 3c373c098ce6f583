// SPDX-License-Identifier: Apache-2.0
#include "ref/objects/static_instances.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <tuple>

#include "ref/geometry/viewpoint.hpp"

namespace halfspace::ref {
namespace {

bool same(const Light& a, const Light& b) {
  const auto all = [](const Light& l) {
    return std::tie(l.kind, l.position, l.direction, l.colour, l.attenuation, l.cos_inner, l.cos_outer);
  };
  return all(a) == all(b);
}

bool same_view_and_light(const Scene& a, const Scene& b, double aspect) {
  return a.instances.size() == b.instances.size() && a.ambient == b.ambient && a.background == b.background &&
         std::equal(a.lights.begin(), a.lights.end(), b.lights.begin(), b.lights.end(), same) &&
         viewpoint(a, aspect) == viewpoint(b, aspect);
}

// The texture of a material; none: nullptr.
const Texture* texture_of(const Scene& scene, const Material& m) {
  return m.texture < 0 ? nullptr : &scene.textures[std::size_t(m.texture)];
}

bool same_material(const Scene& a, int m, const Scene& b, int n) {
  const Material &x = a.materials[std::size_t(m)], &y = b.materials[std::size_t(n)];
  const auto all = [](const Material& of) {
    return std::tie(of.ambient, of.diffuse, of.specular, of.emission, of.shininess, of.two_sided, of.unlit);
  };
  const Texture *s = texture_of(a, x), *t = texture_of(b, y);
  if (all(x) != all(y) || !s != !t) return false;
  return s == t || (s->width == t->width && s->height == t->height && s->texels == t->texels);
}

bool same_mesh(const Mesh& a, const Mesh& b) {
  const auto all = [](const Mesh& m) {
    return std::tie(m.positions, m.normals, m.colours, m.texture_coordinates, m.triangles);
  };
  return all(a) == all(b);
}

}  // namespace

std::vector<bool> same_instances(const Scene& a, const Scene& b, double aspect) {
  std::vector<bool> result(a.instances.size(), false);
  if (!same_view_and_light(a, b, aspect)) return result;
  std::map<std::pair<int, int>, bool> compared;  // meshes, each of many instances
  for (std::size_t n = 0; n < result.size(); ++n) {
    const Instance &x = a.instances[n], &y = b.instances[n];
    if (x.to_world != y.to_world) continue;
    const auto [at, is_new] = compared.try_emplace({x.mesh, y.mesh}, false);
    const Mesh &p = a.meshes[std::size_t(x.mesh)], &q = b.meshes[std::size_t(y.mesh)];
    if (is_new) at->second = same_mesh(p, q) && same_material(a, p.material, b, q.material);
    result[n] = at->second;
  }
  return result;
}

std::vector<bool> static_instances(const Scene& first, const Scene& second, const Scene& between, double aspect) {
  std::vector<bool> result = same_instances(between, first, aspect);
  const std::vector<bool> at_second = same_instances(between, second, aspect);
  std::transform(result.begin(), result.end(), at_second.begin(), result.begin(), std::logical_and<>());
  return result;
}

Scene without(const Scene& scene, const std::vector<bool>& left_out) {
  Scene result = scene;
  result.instances.clear();
  for (std::size_t n = 0; n < scene.instances.size(); ++n) {
    if (!left_out[n]) result.instances.push_back(scene.instances[n]);
  }
  return result;
}

std::vector<std::uint32_t> instances_of_faces(const Scene& scene) {
  std::vector<std::uint32_t> result{0};
  for (std::uint32_t n = 0; n < scene.instances.size(); ++n)
    result.insert(result.end(), scene.meshes[std::size_t(scene.instances[n].mesh)].triangles.size(), n);
  return result;
}

DepthPlanes held_planes(const std::vector<const Scene*>& times, double aspect) {
  DepthPlanes planes = depth_planes(*times.front(), aspect);
  for (const Scene* scene : times) planes = joined(planes, depth_planes(*scene, aspect));
  return planes;
}

}  // namespace halfspace::ref
