// SPDX-License-Identifier: Apache-2.0
// Light that changes between keys: differences of colours over planes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/error.hpp"
#include "tests/motion/ref/squares.hpp"

namespace halfspace::ref {
namespace {

// A ring at rest, and a light that goes around it.
Scene relit_ring(double a) {
  Scene scene = load_scene("ring");
  scene.lights = {Light{}};
  scene.lights[0].direction = glm::normalize(glm::dvec3(std::sin(2 * a), -0.5, -std::cos(2 * a)));
  return scene;
}

TEST(Relight, ByPlanesIsWithinTheRoundings) {
  const At scene = relit_ring;
  UpConversion mode = with(Filter::kBilinear);
  const FrameBetween dark = between(scene, 0.4, mode);
  EXPECT_GT(largest_difference(dark.colour, dark.rendered), 20);
  mode.relight = true;
  const FrameBetween lit = between(scene, 0.4, mode);
  EXPECT_LE(largest_difference(lit.colour, lit.rendered), 1);  // half a step at the keys, half at the end
  mode.method = MotionMethod::kStraight;
  EXPECT_THROW(between(scene, 0.4, mode), Error);
}

// A leaf that shows its other side after the turn: dark in front of the light, light behind it.
TEST(Relight, OfTheSideThatTheKeyShows) {
  const At scene = [](double a) {
    Scene scene = squares({{60, 40, 40, 40}});
    scene.materials[0] = Material{};
    scene.materials[0].two_sided = true;
    scene.lights = {Light{}};
    scene.lights[0].direction = glm::dvec3(0.8, 0, -0.6);
    for (glm::dvec3& p : scene.meshes[0].positions) p -= glm::dvec3(20, -20, 0);
    for (glm::dvec3& n : scene.meshes[0].normals) n = glm::normalize(glm::dvec3(0.3, 0.4, 1));
    const glm::dmat4 place = glm::translate(glm::dmat4(1), glm::dvec3(80, -60, 0));
    scene.instances[0].to_world = glm::rotate(place, a < 0.5 ? 0.0 : 2.6, glm::dvec3(0, 1, 0));
    return scene;
  };
  UpConversion mode = with(Filter::kBilinear);
  mode.relight = true, mode.compensation.use[1] = false;
  const FrameBetween made = between(scene, 0.5, mode);
  EXPECT_GT(made.shares.copied, 1000u);
  EXPECT_LE(largest_difference(made.colour, made.rendered), 2);
  mode.relight = false;
  EXPECT_GT(largest_difference(between(scene, 0.5, mode).colour, made.rendered), 20);
}

// Exact for a texture of one colour, which is its mean.
TEST(Relight, OfATextureGoesByItsMean) {
  const At scene = [](double a) {
    Scene scene = relit_ring(a);
    scene.materials[0].texture = 0;
    scene.textures = {Texture{"grey", 1, 1, {{100, 200, 50}}}};
    scene.meshes[0].texture_coordinates.resize(scene.meshes[0].positions.size());
    return scene;
  };
  UpConversion mode = with(Filter::kBilinear);
  mode.texture = TextureMode{};
  EXPECT_GT(largest_difference(between(scene, 0.4, mode).colour, between(scene, 0.4, mode).rendered), 10);
  mode.relight = true;
  EXPECT_LE(largest_difference(between(scene, 0.4, mode).colour, between(scene, 0.4, mode).rendered), 1);
}

}  // namespace
}  // namespace halfspace::ref
