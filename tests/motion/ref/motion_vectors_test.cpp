// SPDX-License-Identifier: Apache-2.0
// Positions and vectors between key frames against closed formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/motion/ref/times.hpp"

namespace halfspace::ref {
namespace {

TEST(Follow, KeysAreMetToTheBit) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    for (const int key : {0, 1}) {
      const Times t = times(name, 0.3, key);
      const Scene& at_key = key == 0 ? t.first : t.second;
      const Geometry geometry(at_key, kView);
      for (const MotionMethod method : {MotionMethod::kExact, MotionMethod::kStraight}) {
        // Where they meet, the time may be off by its last place: the scene between is the key itself.
        const Between between = follow(method, t.first, t.second, at_key, key, kView);
        EXPECT_EQ(between.fallen_back, 0u);
        expect_same(between.list, geometry.positions());
        for (std::size_t k = 0; k < between.traces.size(); ++k) {
          const auto exact = vectors(between, k)[key].value();
          const auto fixed = fixed_vectors(between, k, kView.subpixel_bits, {9, 4})[key].value();
          EXPECT_EQ(exact, (std::array<glm::dvec2, 3>{}));
          EXPECT_EQ(fixed, (std::array<FixedVector, 3>{}));
        }
      }
    }
  }
}

TEST(Follow, ExactIsTheFrameOfThatTimeAndStraightIsNot) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    const Times t = times(name, 0.3, 0.4);
    const Between exact = t.follow(MotionMethod::kExact), straight = t.follow(MotionMethod::kStraight);
    expect_same(exact.list, Geometry(t.between, kView).positions());
    const FacePlaces here(t.between, kView), from(t.first, kView), to(t.second, kView);
    double off = 0;
    for (std::size_t k = 0; k < straight.traces.size(); ++k) {
      const auto places = here.screen(straight.traces[k].face).value(),
                 a = from.screen(straight.traces[k].face).value(), b = to.screen(straight.traces[k].face).value();
      for (int v = 0; v < 3; ++v) {
        const Vertex& at = straight.list.triangles[k][v];
        EXPECT_NEAR(at.x, a[v].x + 0.4 * (b[v].x - a[v].x), 1e-9);
        EXPECT_NEAR(at.y, a[v].y + 0.4 * (b[v].y - a[v].y), 1e-9);
        EXPECT_NEAR(at.z, a[v].z + 0.4 * (b[v].z - a[v].z), 1e-12);
        off = std::max(off, std::hypot(at.x - places[v].x, at.y - places[v].y));
      }
    }
    EXPECT_GT(off, 1e-4);
    std::printf("%-14s straight lines off by up to %.3f pixels\n", name.c_str(), off);
  }
}

// The picture of a point by similar triangles.
glm::dvec2 seen_at(const glm::dvec3& p) {
  const double scale = kView.height / 2.0 / 0.5;
  return {kView.width / 2.0 + scale * p.x / -p.z, kView.height / 2.0 - scale * p.y / -p.z};
}

// By Rodrigues.
glm::dvec3 rotated(const glm::dvec3& p, const glm::dvec3& axis, double angle) {
  return p * std::cos(angle) + glm::cross(axis, p) * std::sin(angle) + axis * glm::dot(axis, p) * (1 - std::cos(angle));
}

TEST(Vectors, RotationInSpace) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -0.5)), centre(0.4, -0.2, -6);
  const double angle[3] = {0.2, 0.9, 0.5};  // keys, between
  const auto at = [&](double a) {
    Scene scene = load_scene("cube");
    scene.camera = camera_at_origin();
    scene.instances[0].to_world = glm::rotate(glm::translate(glm::dmat4(1), centre), a, axis);
    return scene;
  };
  const Times t{at(angle[0]), at(angle[1]), at(angle[2]), 3 / 7.0};
  const Between between = t.follow(MotionMethod::kExact);
  const Geometry geometry(t.between, kView);
  ASSERT_GE(between.traces.size(), 4u);
  double longest = 0;
  for (std::size_t k = 0; k < between.traces.size(); ++k) {
    const auto to_key = vectors(between, k);
    for (int v = 0; v < 3; ++v) {
      const glm::dvec3 p = t.between.meshes[0].positions[geometry.origins()[k].corner[v]];
      const glm::dvec2 here = seen_at(centre + rotated(p, axis, angle[2]));
      for (int key = 0; key < kKeys; ++key) {
        const glm::dvec2 expected = seen_at(centre + rotated(p, axis, angle[key])) - here;
        EXPECT_LT(glm::distance((*to_key[key])[v], expected), 1e-10);
        longest = std::max(longest, glm::length(expected));
      }
    }
  }
  EXPECT_GT(longest, 10);
}

// Around the line of sight, without perspective: everywhere (R − 1)(p − c), which planes have exactly.
TEST(Vectors, RotationOfThePicture) {
  const auto at = [](double angle) {
    Scene scene = load_scene("castle");
    Camera camera;
    camera.position = {0, 0, 100}, camera.orthographic = true, camera.half_height = 30;
    scene.camera = camera;
    scene.instances[0].to_world = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 0, 1)) * scene.instances[0].to_world;
    return scene;
  };
  const double angle[3] = {-0.1, 0.3, 0.05};
  const Times t{at(angle[0]), at(angle[1]), at(angle[2]), 0.375};
  const Between between = t.follow(MotionMethod::kExact);
  for (const VectorMapping mapping : {VectorMapping::kLinear, VectorMapping::kPerspective}) {
    const MotionField field = motion_field(between, kFormat, mapping);
    // What a plane over the snapped triangle is taken at is off by up to half a sub-pixel, an axis, times the turn.
    const double bound = mapping == VectorMapping::kLinear ? 0.25 * std::sqrt(2) / 512 : 1e-9;
    int pixels = 0;
    for (std::size_t i = 0; i < field.face.size(); ++i) {
      if (field.face[i] == 0) continue;
      const glm::dvec2 arm = centre_of(i) - glm::dvec2(80, 60);
      for (int key = 0; key < kKeys; ++key) {
        const double turn = angle[2] - angle[key];  // rows go downward
        const glm::dvec2 expected(arm.x * std::cos(turn) - arm.y * std::sin(turn),
                                  arm.x * std::sin(turn) + arm.y * std::cos(turn));
        ASSERT_LT(glm::distance(field.to_key[key][i].value(), expected - arm), bound);
      }
      ++pixels;
    }
    EXPECT_GT(pixels, 2000);
  }
}

}  // namespace
}  // namespace halfspace::ref
