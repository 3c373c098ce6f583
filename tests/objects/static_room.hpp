// SPDX-License-Identifier: Apache-2.0
// A room in which some stands and some moves, and up-conversion of it with an S-buffer beside the ordinary one.
#ifndef HALFSPACE_TESTS_OBJECTS_STATIC_ROOM_HPP_
#define HALFSPACE_TESTS_OBJECTS_STATIC_ROOM_HPP_

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>
#include <vector>

#include "model/drivers/up_convert.hpp"
#include "ref/builtin/mesh_builder.hpp"
#include "ref/objects/static_instances.hpp"

namespace halfspace {

using model::Configuration;
using model::KernelFrameBetween;
using model::KernelUpConverter;
using ref::Scene;

constexpr int kWidth = 64, kHeight = 48;
constexpr double kAspect = double(kWidth) / kHeight;

enum RoomPart { kBall, kInPlaneFirst, kWall, kInPlaneLater, kThrough, kBehind, kSurprise, kSleeper, kParts };

inline void add_quad(Scene& scene, const char* name, double rx, double ry) {
  ref::MeshBuilder builder;
  const double hue = 0.11 * double(scene.meshes.size());
  builder.colour = {0.2 + hue, 0.9 - hue, 0.3};
  builder.polygon({{-rx, -ry, 0}, {rx, -ry, 0}, {rx, ry, 0}, {-rx, ry, 0}});
  scene.meshes.push_back(std::move(builder).mesh(name));
  scene.instances.push_back({int(scene.meshes.size()) - 1, glm::dmat4(1)});
}

inline glm::dmat4 at(double x, double y, double z) { return glm::translate(glm::dmat4(1), glm::dvec3(x, y, z)); }

// At fraction `a` of an interval. The wall, the ball and the sleeper stand. Two quads move in the plane of the wall,
// one drawn before it and one after; one turns through it; one passes behind it; one is behind it at both keys and
// before it in between.
inline Scene room(double a) {
  Scene scene;
  scene.name = "room";
  ref::Material two_sided;
  two_sided.two_sided = true;
  scene.materials = {two_sided};
  ref::MeshBuilder ball;
  ball.ellipsoid({0, 0, 0}, glm::dvec3(0.4), 12, 8);
  scene.meshes.push_back(std::move(ball).mesh("ball"));
  scene.instances.push_back({kBall, at(-0.7, -0.5, 0.3)});
  add_quad(scene, "first", 0.25, 0.2);
  add_quad(scene, "wall", 1.1, 0.8);
  add_quad(scene, "later", 0.25, 0.2);
  add_quad(scene, "through", 0.4, 0.3);
  add_quad(scene, "behind", 0.5, 0.3);
  add_quad(scene, "surprise", 0.2, 0.2);
  add_quad(scene, "sleeper", 0.15, 0.3);
  scene.instances[kInPlaneFirst].to_world = at(-0.6 + 0.4 * a, 0.4, 0);
  scene.instances[kInPlaneLater].to_world = at(0.6 - 0.4 * a, -0.4, 0);
  scene.instances[kThrough].to_world = glm::rotate(at(0.5, 0.1 * a, 0), 0.5 + 0.6 * a, glm::dvec3(0.2, 1, 0));
  scene.instances[kBehind].to_world = at(-1.2 + 0.5 * a, -0.6 + 0.3 * a, -0.4);
  scene.instances[kSurprise].to_world = at(0, -0.1, a > 0 && a < 1 ? 0.5 : -0.2);
  scene.instances[kSleeper].to_world = at(1.2, 0.5, 0.1);
  ref::Camera camera;
  camera.position = {0, 0, 4};
  camera.half_height = 0.3;
  scene.camera = camera;
  scene.depth_planes = ref::DepthPlanes{2, 6};
  return scene;
}

inline model::KernelUpConversion mode_of(const char* config, bool static_buffer, int samples = 1) {
  const Configuration colour = model::find_configuration(config);
  Config numbers = model::default_motion(colour.config());
  numbers.samples = samples;
  model::KernelUpConversion mode{kWidth, kHeight, colour,
                                 model::motion_configuration(colour, numbers, kWidth * samples, kHeight * samples)};
  mode.static_buffer = static_buffer;
  return mode;
}

inline bool same(const model::RawMotion& a, const model::RawMotion& b) {
  for (std::size_t k = 0; k < 2; ++k) {
    const model::RawKeyVector &u = a.key[k], &v = b.key[k];
    if (u.there != v.there || u.x != v.x || u.y != v.y || u.difference != v.difference) return false;
  }
  return a.x == b.x && a.y == b.y && a.face == b.face;
}
inline bool same(const std::vector<model::RawMotion>& a, const std::vector<model::RawMotion>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& u, const auto& v) { return same(u, v); });
}

// Both methods side by side.
class Pair {
 public:
  explicit Pair(const char* config, int samples = 1)
      : all_(mode_of(config, false, samples)), static_(mode_of(config, true, samples)), samples_(samples) {}

  struct Both {
    KernelFrameBetween ordinary, with;
  };
  void set_keys(const Scene& first, const Scene& second) {
    first_ = first, second_ = second;
    all_.set_keys(first, second), static_.set_keys(first, second);
  }
  // Holds the one against the other.
  Both at(const Scene& between, double a) {
    Both both{all_.at(between, a), static_.at(between, a)};
    const std::vector<bool> still = ref::static_instances(first_, second_, between, kAspect);
    const std::vector<std::uint32_t> instance = ref::instances_of_faces(between);
    seen_.assign(between.instances.size(), 0);
    std::vector<model::RawMotion> moving;
    std::vector<bool> moves(both.ordinary.rendered.size(), false);
    std::uint64_t standing = 0;
    for (const model::RawMotion& word : all_.input().motion) {
      ++seen_[instance[word.face]];
      if (still[instance[word.face]]) {
        ++standing;
        continue;
      }
      moving.push_back(word);
      moves[std::size_t(word.y / samples_) * kWidth + word.x / samples_] = true;
    }
    EXPECT_TRUE(same(static_.input().motion, moving));
    EXPECT_EQ(both.with.words, moving.size());
    EXPECT_EQ(both.with.shares.still, standing);
    EXPECT_EQ(both.with.shares.background, both.ordinary.shares.background);
    EXPECT_EQ(both.with.rendered, both.ordinary.rendered);
    int wrong = 0;
    for (std::size_t n = 0; n < moves.size(); ++n) {
      if (moves[n] && samples_ != 1) continue;  // some of its samples may stand still
      wrong += both.with.colour[n] != (moves[n] ? both.ordinary.colour[n] : both.with.rendered[n]);
    }
    EXPECT_EQ(wrong, 0);
    return both;
  }
  // Pixels of an instance in the last frame, drawn as a whole.
  int seen(std::size_t instance) const { return seen_[instance]; }

 private:
  KernelUpConverter all_, static_;
  const int samples_;
  Scene first_, second_;
  std::vector<int> seen_;
};

}  // namespace halfspace

#endif  // HALFSPACE_TESTS_OBJECTS_STATIC_ROOM_HPP_
