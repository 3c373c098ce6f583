// SPDX-License-Identifier: Apache-2.0
// Scenes at two key frames and between them.
#ifndef HALFSPACE_TESTS_MOTION_REF_TIMES_HPP_
#define HALFSPACE_TESTS_MOTION_REF_TIMES_HPP_

#include <gtest/gtest.h>

#include <string>

#include "ref/motion/motion_field.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::ref {

inline const RasterFormat kFormat{"motion", 320, 240, 16384, 14, 8, 24};
inline const View kView{160, 120, kFormat.range_bits, kFormat.subpixel_bits};
constexpr double kFrame = 1 / 30.0, kInterval = 5 * kFrame;  // seconds; a key in five

inline glm::dvec2 centre_of(std::size_t pixel) {
  const std::size_t column = pixel % std::size_t(kView.width), row = pixel / std::size_t(kView.width);
  return {double(column) + 0.5, double(row) + 0.5};
}

// A scene at two keys and between them.
struct Times {
  Scene first, second, between;
  double a;
  Between follow(MotionMethod method) const { return ref::follow(method, first, second, between, a, kView); }
};
inline Times times(const std::string& name, double start, double a) {
  return {load_scene(name, start), load_scene(name, start + kInterval), load_scene(name, start + a * kInterval), a};
}

inline void expect_same(const std::array<Vertex, 3>& a, const std::array<Vertex, 3>& b) {
  for (int v = 0; v < 3; ++v) EXPECT_TRUE(a[v].x == b[v].x && a[v].y == b[v].y && a[v].z == b[v].z) << "vertex " << v;
}
inline void expect_same(const TriangleList& a, const TriangleList& b) {
  ASSERT_EQ(a.face, b.face);
  for (std::size_t k = 0; k < a.triangles.size(); ++k) expect_same(a.triangles[k], b.triangles[k]);
}

inline Camera camera_at_origin() {
  Camera camera;
  camera.half_height = 0.5, camera.near = 1, camera.far = 100;
  return camera;
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_MOTION_REF_TIMES_HPP_
