// SPDX-License-Identifier: Apache-2.0
// Which instances are the same at two times, and planes of depth that hold all times.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "ref/geometry/viewpoint.hpp"
#include "tests/objects/static_room.hpp"

namespace halfspace {
namespace {

TEST(StaticInstances, AreThoseOfWhichNothingChanges) {
  const auto held = [](const std::function<void(Scene&)>& change) {
    Scene other = room(0);
    change(other);
    const std::vector<bool> same = ref::same_instances(room(0), other, kAspect);
    return std::count(same.begin(), same.end(), true);
  };
  EXPECT_EQ(held([](Scene&) {}), kParts);
  EXPECT_EQ(held([](Scene& s) { s.meshes[kBall].positions[5].y += 0.01; }), kParts - 1);  // a pose
  EXPECT_EQ(held([](Scene& s) { s.meshes[kBall].normals[5] = {1, 0, 0}; }), kParts - 1);
  EXPECT_EQ(held([](Scene& s) { s.meshes[kWall].triangles[0] = {0, 1, 3}; }), kParts - 1);
  EXPECT_EQ(held([](Scene& s) {
              s.materials.push_back(s.materials[0]);
              s.meshes[kWall].material = 1;
            }),
            kParts);
  EXPECT_EQ(held([](Scene& s) {
              s.materials.push_back({});
              s.meshes[kWall].material = 1;
            }),
            kParts - 1);
  EXPECT_EQ(held([](Scene& s) {
              s.textures = {ref::Texture{"white", 1, 1, {{255, 255, 255}}}};
              s.materials[0].texture = 0;
            }),
            0);
  EXPECT_EQ(held([](Scene& s) { s.instances.pop_back(); }), 0);
}

TEST(StaticInstances, PlanesHoldAllTimes) {
  const Scene near = ref::load_scene("wheel_in_out", 0), far = ref::load_scene("wheel_in_out", 1);
  const ref::DepthPlanes planes = ref::held_planes({&far, &near}, kAspect);
  EXPECT_EQ(planes.near, ref::depth_planes(near, kAspect).near);
  EXPECT_EQ(planes.far, ref::depth_planes(far, kAspect).far);
}

}  // namespace
}  // namespace halfspace
