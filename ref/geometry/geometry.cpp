// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ref/geometry/face_parts.hpp"

namespace halfspace::ref {

Geometry::Geometry(const Scene& scene, const View& view)
    : scene_(scene),
      view_(view),
      viewpoint_(ref::viewpoint(scene, double(view.width) / view.height)),
      lights_(lights_of(scene, viewpoint_)),
      frame_planes_(frame_planes(view)),
      guard_planes_(guard_planes(view)),
      list_{view.width, view.height, {scene.background.r, scene.background.g, scene.background.b}, {}, {}} {
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) draw(i);
}

void Geometry::draw(std::uint32_t instance) {
  const Instance& placed = scene_.instances[instance];
  const Mesh& mesh = scene_.meshes[placed.mesh];
  const bool two_sided = scene_.materials[mesh.material].two_sided;
  const bool mirrored = glm::determinant(glm::dmat3(placed.to_world)) < 0;
  placements_.push_back({normal_matrix(placed.to_world), {}, {}});

  std::vector<glm::dvec4> positions;  // clip space; a vertex is transformed once, however many triangles share it
  for (const glm::dvec3& position : mesh.positions)
    positions.push_back(clip_position(viewpoint_, view_, placed.to_world, position));
  for (std::array<std::uint32_t, 3> corner : mesh.triangles) {
    ++face_;
    if (mirrored) std::swap(corner[1], corner[2]);
    const glm::dvec4 &a = positions[corner[0]], &b = positions[corner[1]], &c = positions[corner[2]];
    std::vector<ClipVertex> polygon{{a, {1, 0, 0}}, {b, {0, 1, 0}}, {c, {0, 0, 1}}};
    if (outside_one(polygon, frame_planes_)) {
      ++unseen_.outside;
      continue;
    }
    // Twice the area on the screen times the three w: right also for triangles that reach behind the viewer.
    const double area = glm::determinant(glm::dmat3(a.x, a.y, a.w, b.x, b.y, b.w, c.x, c.y, c.w));
    const bool faces = area > 0;
    const std::size_t before = list_.triangles.size();
    const std::vector<ClipVertex> left = clip(std::move(polygon), guard_planes_);
    face_parts(left, two_sided, view_, [&](const FacePart& part) {
      list_.triangles.push_back(part.triangle);
      list_.face.push_back(face_);
      origins_.push_back({instance,
                          corner,
                          two_sided && !faces,
                          {part.from[0]->weights, part.from[1]->weights, part.from[2]->weights},
                          {part.from[0]->position.w, part.from[1]->position.w, part.from[2]->position.w}});
    });
    if (list_.triangles.size() != before) continue;
    ++(left.size() < 3 ? unseen_.outside : area < 0 ? unseen_.behind : unseen_.flat);
  }
}

glm::dvec3 Geometry::normal(const Origin& origin, std::uint32_t corner) const {
  const Mesh& mesh = scene_.meshes[scene_.instances[origin.instance].mesh];
  return placed_normal(mesh, corner, placements_[origin.instance].turn, origin.back);
}

glm::dvec3 Geometry::corner_colour(const Origin& origin, std::uint32_t corner) {
  const Instance& instance = scene_.instances[origin.instance];
  const Mesh& mesh = scene_.meshes[instance.mesh];
  std::vector<glm::dvec3>& lit = origin.back ? placements_[origin.instance].back : placements_[origin.instance].front;
  if (lit.empty()) lit.resize(mesh.positions.size(), glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
  glm::dvec3& colour = lit[corner];
  if (std::isnan(colour.x)) {
    const SurfacePoint point =
        placed_vertex(mesh, corner, instance.to_world, placements_[origin.instance].turn, origin.back, viewpoint_);
    colour = phong(point, scene_.materials[mesh.material], scene_.ambient, lights_);
    ++lit_corners_;
  }
  return colour;
}

glm::dvec3 Geometry::colour(std::size_t k) {
  const Origin& origin = origins_[k];
  const glm::dvec3& weights = origin.weights[0];
  glm::dvec3 colour(0);
  for (int i = 0; i < 3; ++i) {
    if (weights[i] != 0) colour += weights[i] * corner_colour(origin, origin.corner[i]);
  }
  return colour;
}

std::array<glm::dvec3, 3> Geometry::colours(const Origin& origin) {
  std::array<glm::dvec3, 3> of_corner, colours;
  for (int i = 0; i < 3; ++i) of_corner[i] = corner_colour(origin, origin.corner[i]);
  for (int v = 0; v < 3; ++v) {
    const glm::dvec3& weights = origin.weights[v];
    colours[v] = weights[0] * of_corner[0] + weights[1] * of_corner[1] + weights[2] * of_corner[2];
  }
  return colours;
}

std::array<glm::dvec3, 3> Geometry::normals(const Origin& origin) const {
  std::array<glm::dvec3, 3> of_corner, normals;
  for (int i = 0; i < 3; ++i) of_corner[i] = normal(origin, origin.corner[i]);
  for (int v = 0; v < 3; ++v) {
    const glm::dvec3& weights = origin.weights[v];
    normals[v] = weights[0] * of_corner[0] + weights[1] * of_corner[1] + weights[2] * of_corner[2];
  }
  return normals;
}

int Geometry::texture(std::size_t k) const {
  const Mesh& mesh = scene_.meshes[scene_.instances[origins_[k].instance].mesh];
  return mesh.texture_coordinates.empty() ? -1 : scene_.materials[mesh.material].texture;
}

std::array<glm::dvec2, 3> Geometry::uv(std::size_t k) const {
  const Origin& origin = origins_[k];
  const Mesh& mesh = scene_.meshes[scene_.instances[origin.instance].mesh];
  std::array<glm::dvec2, 3> coordinates;
  for (int v = 0; v < 3; ++v) {
    coordinates[v] = glm::dvec2(0);
    for (int i = 0; i < 3; ++i) coordinates[v] += origin.weights[v][i] * mesh.texture_coordinates[origin.corner[i]];
  }
  return coordinates;
}

std::string why_unseen(const Scene& scene, const View& view) {
  const Geometry geometry(scene, view);
  const Unseen& unseen = geometry.unseen();
  const std::size_t drawn = geometry.origins().size();
  if (drawn != 0)
    return fmt::format("its {} triangles in the frame cover no pixel centre: take a larger frame or a nearer camera",
                       drawn);
  if (unseen.behind != 0)
    return fmt::format("its {} triangles in the frame are seen from behind, and culled: --two-sided draws them",
                       unseen.behind);
  if (unseen.flat != 0)
    return fmt::format("its {} triangles in the frame are seen edge on or have no area: turn the camera", unseen.flat);
  return fmt::format("its {} triangles are outside of what the camera sees: turn it, or choose another",
                     unseen.outside);
}

TriangleList lit_triangles(Geometry& geometry) {
  TriangleList list = geometry.positions();
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    const auto colours = geometry.colours(k);
    for (int v = 0; v < 3; ++v) {
      Vertex& vertex = list.triangles[k][v];
      vertex.r = colours[v].r, vertex.g = colours[v].g, vertex.b = colours[v].b;
    }
  }
  return list;
}

TriangleList project(const Scene& scene, const View& view) {
  Geometry geometry(scene, view);
  return lit_triangles(geometry);
}

}  // namespace halfspace::ref
