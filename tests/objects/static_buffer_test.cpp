// SPDX-License-Identifier: Apache-2.0
// What the S-buffer of frames between key frames holds: kept while nothing in it changes, drawn anew where it must.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "tests/objects/static_room.hpp"

namespace halfspace {
namespace {

TEST(StaticUpConversion, TheBufferIsKeptWhileNothingInItChanges) {
  Pair pair("low");
  const auto drawn = [&](const Scene& first, const Scene& between, const Scene& second) {
    pair.set_keys(first, second);
    const Pair::Both both = pair.at(between, 0.4);
    EXPECT_GT(both.with.static_instances, 1u);
    return both.with.static_triangles;
  };
  using Change = std::function<void(Scene&)>;
  const auto changed = [&](const Change& change) {
    std::array<Scene, 3> times{room(0), room(0.4), room(1)};
    for (Scene& scene : times) change(scene);
    return drawn(times[0], times[1], times[2]);
  };
  EXPECT_GT(changed([](Scene&) {}), 0u);
  EXPECT_EQ(changed([](Scene&) {}), 0u);
  EXPECT_EQ(changed([](Scene& s) { s.instances[kInPlaneFirst].to_world *= at(0.1, 0, 0); }), 0u);  // moves anyway
  const Change changes[] = {
      [](Scene& s) { s.instances[kSleeper].to_world = at(-1.2, 0.5, 0.1); },
      [](Scene& s) { s.ambient = glm::dvec3(0.1); },
      [](Scene& s) {
        s.background = {200, 0, 0};
      },
      [](Scene& s) { s.lights = {ref::Light()}; },
      [](Scene& s) { s.camera->position.x = 0.1; },
      [](Scene& s) {
        s.depth_planes = ref::DepthPlanes{1, 6};
      },
      [](Scene& s) { s.materials[0].diffuse = glm::dvec3(0.2); },
      [](Scene& s) {
        s.meshes[kWall].colours[2] = {0, 0, 1};
      },
      [](Scene& s) { s.meshes[kWall].positions[2].x = 0.2; },
  };
  for (const Change& change : changes) {
    EXPECT_GT(changed(change), 0u);
    EXPECT_EQ(changed(change), 0u);
  }
  // The ball starts to move, and the sleeper stays.
  changed([](Scene&) {});
  Scene later = room(1);
  later.instances[kBall].to_world = at(-0.6, 0.5, 0.3);
  EXPECT_GT(drawn(room(0), room(0.4), later), 0u);
}

TEST(StaticUpConversion, WhatIsElsewhereInBetweenMoves) {
  Pair pair("low");
  pair.set_keys(room(0), room(1));
  pair.at(room(0.2), 0.2);
  Scene away = room(0.4);
  away.instances[kSleeper].to_world = at(0.9, 0.5, 0.1);
  const Pair::Both both = pair.at(away, 0.4);
  EXPECT_EQ(both.with.static_instances, 2u);
  EXPECT_GT(pair.seen(kSleeper), 10);
  EXPECT_EQ(pair.at(room(0.6), 0.6).with.static_instances, 3u);
}

TEST(StaticUpConversion, IsTheOrdinaryMethodWhereTheViewOrTheLightChanges) {
  using Change = std::function<void(Scene&, double a)>;
  const Change changes[] = {
      [](Scene& s, double a) { s.camera->position.x = 0.2 * a; },
      [](Scene& s, double a) { s.ambient = glm::dvec3(0.2 + 0.1 * a); },
      [](Scene& s, double a) {
        s.lights = {ref::Light()};
        s.lights[0].direction = glm::normalize(glm::dvec3(a, 0, -1));
      },
      [](Scene& s, double a) { s.background.r = 100 * a; },
      // Planes that follow the geometry.
      [](Scene& s, double a) { s.depth_planes.reset(), s.instances[kBehind].to_world = at(0.9, 0, -1 - a); },
  };
  for (const Change& change : changes) {
    const auto scene = [&](double a) {
      Scene s = room(a);
      change(s, a);
      return s;
    };
    Pair pair("low");
    pair.set_keys(scene(0), scene(1));
    const Pair::Both both = pair.at(scene(0.4), 0.4);
    EXPECT_EQ(both.with.static_instances, 0u);
    EXPECT_EQ(both.with.static_triangles, 0u);
    EXPECT_EQ(both.with.colour, both.ordinary.colour);
    EXPECT_EQ(both.with.words, both.ordinary.words);
    EXPECT_EQ(both.with.triangles, both.ordinary.triangles);
  }
}

}  // namespace
}  // namespace halfspace
