// SPDX-License-Identifier: Apache-2.0
#include "ref/objects/object_shader.hpp"

#include <cmath>

#include "ref/geometry/lighting.hpp"
#include "ref/objects/object_raster.hpp"

namespace halfspace::ref {

ObjectShader::ObjectShader(const Scene& scene, const RasterFormat& format, const View& view)
    : scene_(scene), format_(format), view_(view), guard_planes_(guard_planes(view)), background_{0, 0, 0, 255} {
  look_from(ref::viewpoint(scene, double(view.width) / view.height));
  for (int c = 0; c < 3; ++c)
    background_[c] = displayed_colour(snapped_colour(scene.background[c], format.colour_bits), format.colour_bits);
}

void ObjectShader::look_from(const Viewpoint& viewpoint) {
  viewpoint_ = viewpoint;
  lights_ = lights_of(scene_, viewpoint);
  forget();
}

void ObjectShader::prepare(std::uint32_t object, std::uint32_t triangle) {
  object_ = object, triangle_ = triangle;
  const Instance& instance = scene_.instances[object - 1];
  const Mesh& mesh = scene_.meshes[instance.mesh];
  const Material& material = scene_.materials[mesh.material];
  std::array<std::uint32_t, 3> at = mesh.triangles[face_of(triangle)];
  if (glm::determinant(glm::dmat3(instance.to_world)) < 0) std::swap(at[1], at[2]);
  std::array<glm::dvec4, 3> p;
  for (int v = 0; v < 3; ++v) p[v] = clip_position(viewpoint_, view_, instance.to_world, mesh.positions[at[v]]);
  const bool faces =
      glm::determinant(glm::dmat3(p[0].x, p[0].y, p[0].w, p[1].x, p[1].y, p[1].w, p[2].x, p[2].y, p[2].w)) > 0;
  const glm::dmat3 turn = normal_matrix(instance.to_world);
  std::array<glm::dvec3, 3> lit;
  for (int v = 0; v < 3; ++v) {
    const SurfacePoint point =
        placed_vertex(mesh, at[v], instance.to_world, turn, material.two_sided && !faces, viewpoint_);
    lit[v] = phong(point, material, scene_.ambient, lights_);
  }
  SnappedTriangle t{};
  std::vector<ClipVertex> polygon{{p[0], {1, 0, 0}}, {p[1], {0, 1, 0}}, {p[2], {0, 0, 1}}};
  face_parts(clip(std::move(polygon), guard_planes_), material.two_sided, view_, [&](const FacePart& part) {
    if (part.number != part_of(triangle)) return;
    for (int v = 0; v < 3; ++v) {
      t.x[v] = std::int32_t(snapped_position(part.triangle[v].x, view_.subpixel_bits));
      t.y[v] = std::int32_t(snapped_position(part.triangle[v].y, view_.subpixel_bits));
      const glm::dvec3& weights = part.from[v]->weights;
      const glm::dvec3 colour = weights[0] * lit[0] + weights[1] * lit[1] + weights[2] * lit[2];
      for (int c = 0; c < 3; ++c) channel_[c][v] = snapped_colour(colour[c], format_.colour_bits);
    }
  });
  if (format_.flat) {
    for (auto& of_vertex : channel_) of_vertex.fill(of_vertex[0]);
  }
  ordered_.emplace(t);
}

void ObjectShader::shade(ObjectPixel& pixel, int x, int y) {
  if (pixel.colour[3] != 0) return;
  pixel.colour = background_;
  if (pixel.object() == 0) return;
  if (pixel.object() != object_ || pixel.triangle != triangle_) prepare(pixel.object(), pixel.triangle);
  if (ordered_->area == 0) return;
  for (int c = 0; c < 3; ++c) {
    const Plane plane(*ordered_, channel_[c]);
    const Wide numerator =
        plane.numerator(pixel_centre(x, format_.subpixel_bits), pixel_centre(y, format_.subpixel_bits));
    pixel.colour[c] = displayed_colour(unsigned(plane.rounded(numerator)), format_.colour_bits);
  }
}

}  // namespace halfspace::ref
