// SPDX-License-Identifier: Apache-2.0
// The motion field pixel by pixel: a ray for each pixel, and where the point that it meets is at a key.
#ifndef HALFSPACE_TESTS_MOTION_REF_RAYS_HPP_
#define HALFSPACE_TESTS_MOTION_REF_RAYS_HPP_

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tests/motion/ref/times.hpp"

namespace halfspace::ref {

struct FaceOf {
  const Instance* instance;
  std::array<std::uint32_t, 3> corner;
};
inline std::vector<FaceOf> faces_of(const Scene& scene) {
  std::vector<FaceOf> faces;
  for (const Instance& instance : scene.instances) {
    for (const auto& t : scene.meshes[instance.mesh].triangles) faces.push_back({&instance, t});
  }
  return faces;
}
inline glm::dvec3 world(const Scene& scene, const FaceOf& face, int v) {
  return face.instance->to_world * glm::dvec4(scene.meshes[face.instance->mesh].positions[face.corner[v]], 1);
}

// A pixel's ray meets the plane of its face; that point of the surface, moved to the key and projected. None behind its
// near plane.
class Rays {
 public:
  explicit Rays(const Times& t)
      : t_(t),
        scenes_{&t.first, &t.second},
        faces_(faces_of(t.between)),
        key_faces_{faces_of(t.first), faces_of(t.second)} {
    const double aspect = double(kView.width) / kView.height;
    from_clip_ = glm::inverse(viewpoint(t.between, aspect).to_clip);
    for (int key = 0; key < kKeys; ++key) to_clip_[key] = viewpoint(*scenes_[key], aspect).to_clip;
  }
  std::optional<glm::dvec2> vector(std::uint32_t face, std::size_t pixel, int key) const {
    const glm::dvec2 centre = centre_of(pixel);
    const glm::dvec2 ndc(2 * centre.x / kView.width - 1, 1 - 2 * centre.y / kView.height);
    const glm::dvec4 near = from_clip_ * glm::dvec4(ndc, 0, 1), far = from_clip_ * glm::dvec4(ndc, 1, 1);
    const glm::dvec3 start = glm::dvec3(near) / near.w, way = glm::dvec3(far) / far.w - start;
    const FaceOf &here = faces_[face - 1], &there = key_faces_[key][face - 1];
    const glm::dvec3 p = world(t_.between, here, 0);
    const glm::dvec3 uv =
        glm::inverse(glm::dmat3(world(t_.between, here, 1) - p, world(t_.between, here, 2) - p, -way)) * (start - p);
    const glm::dvec3 q = world(*scenes_[key], there, 0);
    const glm::dvec3 moved =
        q + uv.x * (world(*scenes_[key], there, 1) - q) + uv.y * (world(*scenes_[key], there, 2) - q);
    const glm::dvec4 clip = to_clip_[key] * glm::dvec4(moved, 1);
    if (clip.z < -1e-6 * clip.w || clip.w <= 0) return std::nullopt;
    return glm::dvec2(kView.width * (clip.x / clip.w + 1) / 2, kView.height * (1 - clip.y / clip.w) / 2) - centre;
  }

 private:
  const Times& t_;
  OfKeys<const Scene*> scenes_;
  std::vector<FaceOf> faces_;
  OfKeys<std::vector<FaceOf>> key_faces_;
  glm::dmat4 from_clip_;
  OfKeys<glm::dmat4> to_clip_;
};

struct Seen {
  double perspective = 0, linear = 0;  // largest distance from the ray's vector, pixels
  int vectors = 0, absent = 0;         // of the perspective-correct field
};
inline Seen compare_with_rays(const Times& t) {
  const Between between = t.follow(MotionMethod::kExact);
  const Frame frame = render(snap(Geometry(t.between, kView).positions(), kFormat));
  const MotionField exact = motion_field(between, kFormat, VectorMapping::kPerspective),
                    linear = motion_field(between, kFormat, VectorMapping::kLinear);
  EXPECT_EQ(exact.triangle, frame.index);
  const Rays rays(t);
  Seen seen;
  for (std::size_t i = 0; i < exact.face.size(); ++i) {
    for (int key = 0; key < kKeys; ++key) {
      const auto& vector = exact.to_key[key][i];
      if (exact.face[i] == 0) {
        EXPECT_FALSE(vector || linear.to_key[key][i]);
        continue;
      }
      const auto expected = rays.vector(exact.face[i], i, key);
      EXPECT_EQ(bool(vector), bool(expected)) << "pixel " << i;
      if (!vector || !expected) {
        ++seen.absent;
        continue;
      }
      ++seen.vectors;
      seen.perspective = std::max(seen.perspective, glm::distance(*vector, *expected));
      if (linear.to_key[key][i]) seen.linear = std::max(seen.linear, glm::distance(*linear.to_key[key][i], *expected));
    }
  }
  return seen;
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_MOTION_REF_RAYS_HPP_
