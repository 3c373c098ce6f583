// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/relight.hpp"

#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/plane.hpp"

namespace halfspace::ref {
namespace {

// 0-1.
glm::dvec3 mean(const Texture& texture) {
  glm::dvec3 sum(0);
  for (const auto& texel : texture.texels) sum += glm::dvec3(texel[0], texel[1], texel[2]);
  return sum / (255.0 * double(texture.texels.size()));
}

// Where it is in the frame of `geometry`: the side of a two-sided face that is seen there.
Origin seen_in(const Geometry& geometry, Origin origin) {
  const Scene& scene = geometry.scene();
  const Instance& instance = scene.instances[origin.instance];
  const Mesh& mesh = scene.meshes[instance.mesh];
  if (!scene.materials[mesh.material].two_sided) return origin;
  glm::dmat3 corners;  // x, y, w: the sign of its determinant is that of the area, in front of the viewer and behind
  for (int v = 0; v < 3; ++v) {
    const glm::dvec4 clip =
        geometry.viewpoint().to_clip * (instance.to_world * glm::dvec4(mesh.positions[origin.corner[v]], 1));
    corners[v] = {clip.x, clip.y, clip.w};
  }
  origin.back = glm::determinant(corners) <= 0;
  return origin;
}

using Colours3 = std::array<glm::dvec3, 3>;

// `here` and `there` give the colours of the vertices of triangle k, in between and at the key.
template <class Here, class There>
LightChange change_of(const Geometry& between, int colour_bits, bool textured, Here here, There there) {
  std::vector<glm::dvec3> means;
  for (const Texture& texture : between.scene().textures) means.push_back(mean(texture));
  const auto rounded = [&](double colour) {
    return double(displayed_colour(snapped_colour(colour, colour_bits), colour_bits));
  };
  LightChange change;
  for (std::size_t k = 0; k < between.origins().size(); ++k) {
    const Colours3 from = there(k), to = here(k);
    const int texture = textured ? between.texture(k) : -1;
    auto& of_vertex = change.emplace_back();
    for (int v = 0; v < 3; ++v) {
      for (int c = 0; c < 3; ++c) of_vertex[v][c] = rounded(to[v][c]) - rounded(from[v][c]);
      if (texture >= 0) of_vertex[v] *= means[texture];
    }
  }
  return change;
}

}  // namespace

LightChange light_change(Geometry& between, Geometry& key, int colour_bits, bool textured) {
  return change_of(
      between, colour_bits, textured, [&](std::size_t k) { return between.colours(k); },
      [&](std::size_t k) { return key.colours(seen_in(key, between.origins()[k])); });
}

LightChange distant_light_change(const Geometry& between, const Geometry& key, int most_squarings, int colour_bits,
                                 bool textured) {
  const DistantScene lit_here = distant_scene(between.scene(), between.viewpoint(), most_squarings);
  const DistantScene lit_there = distant_scene(key.scene(), key.viewpoint(), most_squarings);
  const auto colours = [&](const DistantScene& lit, std::size_t k, const Colours3& normals) {
    const int material = lit.triangles[lit.of_face[between.positions().face[k] - 1]].material;
    Colours3 out;
    for (int v = 0; v < 3; ++v) out[v] = distant_colour(lit.materials[material], lit.lights, normals[v]);
    return out;
  };
  return change_of(
      between, colour_bits, textured, [&](std::size_t k) { return colours(lit_here, k, between.normals(k)); },
      [&](std::size_t k) { return colours(lit_there, k, key.normals(seen_in(key, between.origins()[k]))); });
}

LightPlanes light_planes(const Between& between, const MotionField& field, const RasterFormat& format,
                         const OfKeys<LightChange>& change) {
  const SnappedList list = snap(between.list, format);
  LightPlanes out;
  for (auto& of_key : out) of_key.resize(field.face.size());
  for (std::size_t at = 0; at < field.face.size(); ++at) {
    const std::uint32_t k = field.triangle[at];
    if (k == 0) continue;
    const OrderedTriangle t(list.triangles[k - 1]);
    const auto weights = vertex_weights(t, pixel_centre(std::int64_t(at % field.width), format.subpixel_bits),
                                        pixel_centre(std::int64_t(at / field.width), format.subpixel_bits));
    for (int key = 0; key < kKeys; ++key) {
      for (int v = 0; v < 3; ++v) out[key][at] += weights[v] * change[key][k - 1][v];
    }
  }
  return out;
}

}  // namespace halfspace::ref
