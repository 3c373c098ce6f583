// SPDX-License-Identifier: Apache-2.0
// The geometry stage: from a scene to the triangles of a frame. Positions come first; lighting is asked for triangle by
// triangle, so that it can wait until a triangle has turned out visible (deferred lighting).
#ifndef HALFSPACE_REF_GEOMETRY_GEOMETRY_HPP_
#define HALFSPACE_REF_GEOMETRY_GEOMETRY_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ref/geometry/clip.hpp"
#include "ref/geometry/lighting.hpp"
#include "ref/geometry/projection.hpp"
#include "ref/geometry/triangle_list.hpp"
#include "ref/geometry/viewpoint.hpp"
#include "ref/scene/scene.hpp"

namespace halfspace::ref {

// What a triangle of a frame is a part of.
struct Origin {
  std::uint32_t instance;               // of the scene
  std::array<std::uint32_t, 3> corner;  // vertices of the mesh, counter-clockwise seen from outside
  bool back;                            // a two-sided one, seen from behind
  std::array<glm::dvec3, 3> weights;    // of the corners at each of its vertices: (1, 0, 0), … unless it was clipped
  std::array<double, 3> w;              // of its vertices in clip space
};

// Faces of which nothing is drawn: outside of the frame, seen from behind, or without an area there.
struct Unseen {
  std::uint64_t outside = 0, behind = 0, flat = 0;
};

// Transform, clipping, division, viewport, culling by the constructor; Phong lighting at the vertices on request.
// Triangles come in the order of instances, meshes and faces, each with the number of its face, which no view changes.
// There may be none. The scene outlives it.
class Geometry {
 public:
  Geometry(const Scene&, const View&);

  const TriangleList& positions() const { return list_; }  // all black
  const std::vector<Origin>& origins() const { return origins_; }
  const Unseen& unseen() const { return unseen_; }
  const Scene& scene() const { return scene_; }
  const Viewpoint& viewpoint() const { return viewpoint_; }

  // Of the vertices of triangle `k` (from 0 on), 0-255. A corner is lit once, however many triangles share it.
  std::array<glm::dvec3, 3> colours(std::size_t k) { return colours(origins_[k]); }
  // Of points of a face, whether or not a triangle of this frame shows them.
  std::array<glm::dvec3, 3> colours(const Origin&);
  // The one of vertex 0.
  glm::dvec3 colour(std::size_t k);
  std::uint64_t lit_corners() const { return lit_corners_; }

  // In the world, on the side that is seen, of length 1 unless the triangle was clipped.
  std::array<glm::dvec3, 3> normals(std::size_t k) const { return normals(origins_[k]); }
  std::array<glm::dvec3, 3> normals(const Origin&) const;
  // −1 where the material has no texture or the mesh no coordinates.
  int texture(std::size_t k) const;
  // (u, v) of the vertices of a triangle that has a texture.
  std::array<glm::dvec2, 3> uv(std::size_t k) const;

 private:
  // A mesh in its place.
  struct Placement {
    glm::dmat3 turn;                      // of normals
    std::vector<glm::dvec3> front, back;  // colours of either side as far as they were asked for; else NaN
  };
  void draw(std::uint32_t instance);
  glm::dvec3 normal(const Origin&, std::uint32_t corner) const;
  glm::dvec3 corner_colour(const Origin&, std::uint32_t corner);

  const Scene& scene_;
  const View view_;
  const Viewpoint viewpoint_;
  std::vector<Light> lights_;
  std::vector<ClipPlane> frame_planes_, guard_planes_;
  TriangleList list_;
  std::vector<Origin> origins_;
  Unseen unseen_;
  std::vector<Placement> placements_;  // one an instance
  std::uint32_t face_ = 0;             // of the scene, the one at hand
  std::uint64_t lit_corners_ = 0;
};

// Of a view that shows nothing of the scene: whether camera, culling or size is the reason, and a remedy.
std::string why_unseen(const Scene&, const View&);

// The positions, with the colours of all vertices; and all of it at once.
TriangleList lit_triangles(Geometry&);
TriangleList project(const Scene&, const View&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_GEOMETRY_GEOMETRY_HPP_
