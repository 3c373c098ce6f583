// SPDX-License-Identifier: Apache-2.0
// Animated scenes: what moves in them, and that it stays in the frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/motion/ref/times.hpp"

namespace halfspace::ref {
namespace {

std::vector<glm::dmat4> placed(const Scene& scene) {
  std::vector<glm::dmat4> matrices;
  for (const Instance& instance : scene.instances) matrices.push_back(instance.to_world);
  return matrices;
}

TEST(AnimatedScenes, MoveAndStayInTheFrame) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    const Scene start = load_scene(name);
    ASSERT_GE(start.duration, 1);
    EXPECT_EQ(placed(load_scene(name, 0.4)) == placed(start), name == "cube_zoom");
    EXPECT_EQ(placed(load_scene(name, -1)), placed(start));
    EXPECT_EQ(placed(load_scene(name, start.duration + 1)), placed(load_scene(name, start.duration)));
    const Viewpoint eye = viewpoint(start, 4 / 3.0);
    std::size_t most = 0, least = 1000000;
    for (int frame = 0; frame <= start.duration / kFrame; ++frame) {
      const Scene scene = load_scene(name, frame * kFrame);
      const Geometry geometry(scene, kView);  // throws when nothing is seen
      most = std::max(most, geometry.origins().size()), least = std::min(least, geometry.origins().size());
      const double moved = glm::distance(viewpoint(scene, 4 / 3.0).eye, eye.eye);
      if (name != "cube_zoom") {
        EXPECT_EQ(moved, 0);
      } else if (frame == 7) {
        EXPECT_GT(moved, 1);
      }
    }
    std::printf("%-14s %zu to %zu of %zu faces drawn\n", name.c_str(), least, most, FacePlaces(start, kView).faces());
  }
}

// Its castle stands; the drone takes off half a second after the start, its blades turn all the time.
TEST(AnimatedScenes, TheCourtStands) {
  const Scene start = load_scene("court");
  for (const auto& [seconds, moving] : {std::pair(0.4, 12), std::pair(1.0, 17)}) {
    const Scene now = load_scene("court", seconds);
    EXPECT_EQ(now.instances[0].to_world, start.instances[0].to_world);
    int moved = 0;
    for (std::size_t n = 0; n < start.instances.size(); ++n)
      moved += now.instances[n].to_world != start.instances[n].to_world;
    EXPECT_EQ(moved, moving) << seconds;
  }
}

TEST(AnimatedScenes, FightersHaveManyPartsAndOutwardNormals) {
  for (const char* name : {"drone", "jet"}) {
    SCOPED_TRACE(name);
    const Scene scene = load_scene(name, 0.5);
    EXPECT_GE(scene.instances.size(), 13u);
    EXPECT_GE(FacePlaces(scene, kView).faces(), 3000u);
    for (const Mesh& mesh : scene.meshes) {
      for (const auto& t : mesh.triangles) {
        const auto& p = mesh.positions;
        const glm::dvec3 across = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
        ASSERT_GT(glm::length(across), 1e-9) << mesh.name;
        for (const std::uint32_t i : t) {
          EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-9);
          ASSERT_GT(glm::dot(glm::normalize(across), mesh.normals[i]), 0.1) << mesh.name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace halfspace::ref
