// SPDX-License-Identifier: Apache-2.0
#include "ref/geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/clip.hpp"
#include "ref/error.hpp"
#include "ref/lighting.hpp"
#include "ref/plane.hpp"
#include "ref/snap.hpp"
#include "ref/viewpoint.hpp"

namespace halfspace::ref {
namespace {

// What a mesh comes to in one place: a vertex is transformed and lit once, however many triangles share it.
struct LitMesh {
  std::vector<glm::dvec4> positions;    // clip space
  std::vector<glm::dvec3> front, back;  // colours of either side; back only if two-sided
};

class Geometry {
 public:
  Geometry(const Scene& scene, const View& view)
      : scene_(scene),
        view_(view),
        viewpoint_(viewpoint(scene, double(view.width) / view.height)),
        lights_(lights_of(scene, viewpoint_)),
        frame_planes_(planes_around(0, view.width, 0, view.height)),
        list_{view.width, view.height, {scene.background.r, scene.background.g, scene.background.b}, {}, {}} {
    // One pixel inside the range, so that neither rounding nor snapping leads out of it.
    const double guard = std::ldexp(1.0, view.range_bits - 1) - 1;
    guard_planes_ = planes_around(-guard, guard, -guard, guard);
  }

  TriangleList run() {
    for (const Instance& instance : scene_.instances) draw(instance);
    if (list_.triangles.empty()) {
      throw Error(fmt::format(
          "{}: no triangle faces the camera within the frame; turn the camera, or take it out of the file"
          " to have the scene framed",
          scene_.name));
    }
    return std::move(list_);
  }

 private:
  // Near and far, then the sides of a rectangle in pixels. Near comes first: behind it w > 0, and a side only
  // means what it should there.
  std::vector<ClipPlane> planes_around(double left, double right, double top, double bottom) const {
    const double w = view_.width / 2.0, h = view_.height / 2.0;  // pixel = (w + w x/w_clip, h - h y/w_clip)
    return {{0, 0, 1, 0},          {0, 0, -1, 1},       {w, 0, 0, w - left},
            {-w, 0, 0, right - w}, {0, -h, 0, h - top}, {0, h, 0, bottom - h}};
  }

  LitMesh light(const Mesh& mesh, const Material& material, const glm::dmat4& to_world) const {
    LitMesh lit;
    // The cofactors turn normals rightly under any scale, and mirrors too; and need no inverse.
    const glm::dmat3 m(to_world);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double handedness = glm::determinant(m) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const glm::dvec4 world = to_world * glm::dvec4(mesh.positions[i], 1);
      glm::dvec4 position = viewpoint_.to_clip * world;
      position.x += 2 * view_.shift_x / view_.width * position.w;
      position.y -= 2 * view_.shift_y / view_.height * position.w;
      lit.positions.push_back(position);
      SurfacePoint point{world, handedness * (cofactors * mesh.normals[i]), viewpoint_.to_viewer(world),
                         mesh.colours.empty() ? glm::dvec3(1) : mesh.colours[i]};
      const double length = glm::length(point.normal);
      if (length > 0) point.normal /= length;
      lit.front.push_back(phong(point, material, scene_.ambient, lights_));
      if (!material.two_sided) continue;
      point.normal = -point.normal;
      lit.back.push_back(phong(point, material, scene_.ambient, lights_));
    }
    return lit;
  }

  void draw(const Instance& instance) {
    const Mesh& mesh = scene_.meshes[instance.mesh];
    const Material& material = scene_.materials[mesh.material];
    const LitMesh lit = light(mesh, material, instance.to_world);
    const bool mirrored = glm::determinant(glm::dmat3(instance.to_world)) < 0;
    for (std::array<std::uint32_t, 3> corner : mesh.triangles) {
      ++face_;
      if (mirrored) std::swap(corner[1], corner[2]);
      const glm::dvec4 &a = lit.positions[corner[0]], &b = lit.positions[corner[1]],
                       &c = lit.positions[corner[2]];
      // Twice the area on the screen times the three w: right also for triangles that reach behind the
      // viewer.
      const bool faces = glm::determinant(glm::dmat3(a.x, a.y, a.w, b.x, b.y, b.w, c.x, c.y, c.w)) > 0;
      const auto& colours = material.two_sided && !faces ? lit.back : lit.front;
      std::vector<ClipVertex> polygon;
      for (const std::uint32_t i : corner) polygon.push_back({lit.positions[i], colours[i]});
      if (outside_one(polygon, frame_planes_)) continue;
      emit(clip(std::move(polygon), guard_planes_), material.two_sided);
    }
  }

  void emit(const std::vector<ClipVertex>& polygon, bool two_sided) {
    std::vector<Vertex> corners;
    for (const ClipVertex& v : polygon) corners.push_back(viewport(v));
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const std::array<Vertex, 3> triangle{corners[0], corners[i - 1], corners[i]};
      if (!two_sided && !faces_viewer(triangle)) continue;
      list_.triangles.push_back(triangle);
      list_.face.push_back(face_);
    }
  }

  Vertex viewport(const ClipVertex& v) const {
    const glm::dvec3 p = glm::dvec3(v.position) / v.position.w;
    return {view_.width * (0.5 + 0.5 * p.x),
            view_.height * (0.5 - 0.5 * p.y),
            std::clamp(p.z, 0.0, 1.0),
            v.colour.r,
            v.colour.g,
            v.colour.b};
  }

  // Counter-clockwise on the screen, which is a negative area as rows go downward. As snapped, so that what
  // is kept is what the rasterizer sees.
  bool faces_viewer(const std::array<Vertex, 3>& t) const {
    std::array<Wide, 3> x, y;
    for (int i = 0; i < 3; ++i) {
      x[i] = std::int64_t(snapped_position(t[i].x, view_.subpixel_bits));
      y[i] = std::int64_t(snapped_position(t[i].y, view_.subpixel_bits));
    }
    return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]) < 0;
  }

  const Scene& scene_;
  const View& view_;
  const Viewpoint viewpoint_;
  std::vector<Light> lights_;
  std::vector<ClipPlane> frame_planes_, guard_planes_;
  TriangleList list_;
  std::uint32_t face_ = 0;  // of the scene, the one at hand
};

}  // namespace

TriangleList project(const Scene& scene, const View& view) { return Geometry(scene, view).run(); }

}  // namespace halfspace::ref
