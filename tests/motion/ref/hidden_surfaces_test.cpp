// SPDX-License-Identifier: Apache-2.0
// What one key frame or both do not show: copied from the other, or rendered.
#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/motion/ref/squares.hpp"

namespace halfspace::ref {
namespace {

constexpr Square kWall{0, 0, kWidth, kHeight, -20, {0.3, 0.5, 0.7}};

TEST(Hidden, InOneKeyIsCopiedFromTheOther) {
  const At scene = [](double a) { return squares({kWall, {20 + 40 * a, 50, 30, 20}}); };  // 20, 36, 60
  for (const Filter filter : kFilters) {
    const FrameBetween made = between(scene, 0.4, with(filter));
    EXPECT_EQ(made.colour, made.rendered) << name_of(filter);
    EXPECT_EQ(made.shares.filled, 0u);
    EXPECT_EQ(made.shares.copied, 16u * 20 + 24 * 20);
  }
  UpConversion blind = with(Filter::kBilinear);
  blind.compensation.index_test = false;
  EXPECT_GT(largest_difference(between(scene, 0.4, blind).colour, between(scene, 0.4, blind).rendered), 50);
  UpConversion first = with(Filter::kBilinear);
  first.compensation.use[1] = false;
  EXPECT_EQ(between(scene, 0.4, first).shares.filled, 16u * 20);
}

TEST(Hidden, InBothKeysIsRendered) {
  // The place at (20, 50) is behind one square at the first key and behind another at the second.
  const At scene = [](double a) {
    return squares(
        {kWall, {a > 0 ? 100.0 : 20.0, 50, 30, 20, 0, {0.9, 0.1, 0.1}}, {a < 1 ? 60.0 : 20.0, 50, 30, 20, 5}});
  };
  for (const Filter filter : kFilters) {
    const FrameBetween made = between(scene, 0.4, with(filter));
    EXPECT_EQ(made.colour, made.rendered) << name_of(filter);
    EXPECT_EQ(made.shares.filled, 30u * 20);
  }
}

TEST(Hidden, WhatEntersOrLeavesIsCopied) {
  for (const bool enters : {false, true}) {
    const At scene = [&](double a) { return squares({{-40 + 60 * (enters ? a : 1 - a), 50, 30, 20}}); };
    const FrameBetween made = between(scene, 0.5, with(Filter::kBilinear));  // −10 … 20
    EXPECT_EQ(made.colour, made.rendered);
    EXPECT_EQ(made.shares.copied, 20u * 20);
    EXPECT_EQ(made.shares.filled, 0u);
  }
}

TEST(Hidden, MovedByMoreThanTheFrameIsRendered) {
  const At scene = [](double a) { return squares({{-300 + 700 * a, 50, 30, 20}}); };
  const FrameBetween made = between(scene, 0.5, with(Filter::kBicubic));
  EXPECT_EQ(made.colour, made.rendered);
  EXPECT_EQ(made.shares.filled, 30u * 20);
  EXPECT_EQ(made.shares.blended, 1u);
}

// Of the two faces of a cube that are seen between the keys, either was seen at one of them.
TEST(Hidden, HalfATurn) {
  const At scene = [](double a) {
    Scene scene = squares({});
    Scene turning = load_scene("cube");
    const glm::dmat4 place = glm::translate(glm::dmat4(1), glm::dvec3(80, -60, 0));
    scene.meshes.push_back(turning.meshes[0]);
    scene.meshes.back().material = 1;
    scene.materials.push_back(turning.materials[0]);
    scene.instances.push_back(
        {1, glm::scale(glm::rotate(place, 0.5 + glm::pi<double>() * (a - 0.5), glm::dvec3(0, 1, 0)), glm::dvec3(25))});
    return scene;
  };
  UpConversion mode = with(Filter::kNearest);
  mode.relight = true;
  const FrameBetween made = between(scene, 0.5, mode);
  EXPECT_EQ(made.shares.blended, 1u);  // the corner's
  EXPECT_GT(made.shares.copied, 10 * made.shares.filled);
  EXPECT_LE(largest_difference(made.colour, made.rendered), 2);
  // On straight lines it collapses, and what was behind it is seen.
  mode.relight = false, mode.method = MotionMethod::kStraight;
  const FrameBetween straight = between(scene, 0.5, mode);
  EXPECT_LT(straight.shares.blended + straight.shares.copied + straight.shares.filled, made.shares.copied / 4);
}

// A floor that reaches behind the viewer, who goes forward.
TEST(Hidden, AcrossTheNearPlane) {
  const At scene = [](double a) {
    Scene scene = squares({}, noise(4));
    scene.camera->orthographic = false, scene.camera->half_height = 0.5, scene.camera->near = 1,
    scene.camera->far = 400;
    scene.camera->position = {0, 0, 8 - 4 * a};
    scene.meshes[0].positions = {{-40, -2, 20}, {40, -2, 20}, {40, -2, -40}, {-40, -2, -40}};
    scene.meshes[0].normals.assign(4, {0, 1, 0});
    scene.instances[0].to_world = glm::dmat4(1);
    return scene;
  };
  UpConversion mode = with(Filter::kBilinear);
  mode.texture = TextureMode{};
  mode.mapping = VectorMapping::kPerspective;
  const FrameBetween perspective = between(scene, 0.5, mode);
  EXPECT_EQ(perspective.shares.filled, 0u);  // the first key has all of it
  EXPECT_GT(perspective.shares.copied, 500u);
  EXPECT_GT(quality(perspective.colour, perspective.rendered, kWidth, kHeight).psnr_y, 40);
  mode.mapping = VectorMapping::kLinear;
  const FrameBetween linear = between(scene, 0.5, mode);
  EXPECT_GT(linear.shares.copied, perspective.shares.copied);  // a whole triangle has no vectors
  EXPECT_LT(quality(linear.colour, linear.rendered, kWidth, kHeight).psnr_y, 35);
}

}  // namespace
}  // namespace halfspace::ref
