// SPDX-License-Identifier: Apache-2.0
// Frames between keys against what they are worked out to be by hand, and against the rendered ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/error.hpp"
#include "ref/motion/up_convert.hpp"

namespace halfspace::ref {
namespace {

constexpr double kPi = glm::pi<double>();
constexpr int kWidth = 160, kHeight = 120;
const UpConversion kPlain{kWidth, kHeight, {"frames", 0, 0, 16384, 14, 8, 24}};

// --- weights ---

TEST(Weights, SumToOneAndAreSymmetrical) {
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0;
    for (const Filter filter : {Filter::kBilinear, Filter::kArea}) {
      const auto w = axis_weights(filter, t), mirrored = axis_weights(filter, 1 - t);
      EXPECT_NEAR(w[0] + w[1], 1, 1e-15);
      EXPECT_NEAR(w[0], mirrored[1], 1e-15);
      EXPECT_EQ(w[0] > w[1], t < 0.5);
    }
    const auto c = cubic_weights(t), mirrored = cubic_weights(1 - t);
    EXPECT_NEAR(c[0] + c[1] + c[2] + c[3], 1, 1e-15);
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(c[k], mirrored[3 - k], 1e-15);
    EXPECT_NEAR(-c[0] + c[2] + 2 * c[3], t, 1e-15);  // a line stays a line
  }
  EXPECT_EQ(axis_weights(Filter::kBilinear, 0.25), (std::array<double, 2>{0.75, 0.25}));
  EXPECT_EQ(axis_weights(Filter::kArea, 0.25), (std::array<double, 2>{0.9, 0.1}));
  EXPECT_EQ(cubic_weights(0.5), (std::array<double, 4>{-1 / 16.0, 9 / 16.0, 9 / 16.0, -1 / 16.0}));
  EXPECT_EQ(cubic_weights(0), (std::array<double, 4>{0, 1, 0, 0}));
}

// --- one fetch ---

// Red counts pixels, all of identity 1 but for those named.
KeyFrame counted(int width, int height, const std::vector<std::array<int, 2>>& others = {}) {
  KeyFrame key{width, height, {}, std::vector<std::uint32_t>(std::size_t(width) * height, 1)};
  for (int i = 0; i < width * height; ++i) key.colour.push_back({std::uint8_t(10 * i), 0, 0, 255});
  for (const auto& [x, y] : others) key.identity[std::size_t(y) * width + x] = 2;
  return key;
}
double red(const KeyFrame& key, double x, double y, Filter filter, std::uint32_t identity = 1, bool test = true) {
  const auto colour = fetch(key, {x, y}, identity, {filter, test, {true, true}, 0});
  return colour ? colour->x : -1;
}

TEST(Fetch, NearestIsThePixelThatThePlaceLiesIn) {
  const KeyFrame key = counted(3, 2, {{1, 1}});  // 0 10 20 / 30 40 50
  EXPECT_EQ(red(key, 2.0, 0.99, Filter::kNearest), 20);
  EXPECT_EQ(red(key, 0.0, 1.0, Filter::kNearest), 30);
  EXPECT_EQ(red(key, 1.5, 1.5, Filter::kNearest), -1);
  EXPECT_EQ(red(key, 1.5, 1.5, Filter::kNearest, 2), 40);
  EXPECT_EQ(red(key, 1.5, 1.5, Filter::kNearest, 1, false), 40);
  for (const auto& [x, y] : {std::pair(-0.01, 0.5), std::pair(3.0, 0.5), std::pair(0.5, 2.0), std::pair(0.5, -0.01)})
    EXPECT_EQ(red(key, x, y, Filter::kNearest, 1, false), -1);
}

TEST(Fetch, BilinearMovesTheWeightOfWhatDoesNotMatch) {
  // At (1.25 − ½, 1.125 − ½) beyond pixel (0, 0): t = 0.75, 0.625; weights 0.09375 0.28125 / 0.15625 0.46875.
  const double x = 1.25, y = 1.125;
  const auto at = [&](const std::vector<std::array<int, 2>>& others) {
    return red(counted(2, 2, others), x, y, Filter::kBilinear);  // 0 10 / 20 30
  };
  EXPECT_DOUBLE_EQ(at({}), 10 * 0.28125 + 20 * 0.15625 + 30 * 0.46875);
  EXPECT_DOUBLE_EQ(at({{0, 0}}), 10 * 0.28125 + 20 * 0.15625 + 30 * (0.46875 + 0.09375));
  // Without the nearest, (1, 1): the neighbour along y, whose fraction is nearer to ½, is (1, 0).
  EXPECT_DOUBLE_EQ(at({{1, 1}}), 10 * (0.28125 + 0.46875) + 20 * 0.15625);
  EXPECT_DOUBLE_EQ(at({{1, 1}, {1, 0}}), 20 * (1 - 0.09375));
  EXPECT_DOUBLE_EQ(at({{1, 1}, {1, 0}, {0, 1}}), 0);
  EXPECT_DOUBLE_EQ(at({{1, 1}, {0, 0}, {0, 1}}), 10);
  EXPECT_EQ(at({{1, 1}, {1, 0}, {0, 1}, {0, 0}}), -1);
  EXPECT_DOUBLE_EQ(red(counted(2, 2, {{1, 1}}), x, y, Filter::kBilinear, 1, false),
                   10 * 0.28125 + 20 * 0.15625 + 30 * 0.46875);
}

TEST(Fetch, TiesGoRightDownAndAlongX) {
  const auto at = [](double x, double y, int other_x, int other_y) {
    return red(counted(2, 2, {{other_x, other_y}}), x, y, Filter::kBilinear);  // 0 10 / 20 30
  };
  EXPECT_DOUBLE_EQ(at(1, 0.75, 0, 1), 10 * (0.375 + 0.125) + 30 * 0.125);
  EXPECT_DOUBLE_EQ(at(0.75, 1, 1, 0), 20 * (0.375 + 0.125) + 30 * 0.125);
  EXPECT_DOUBLE_EQ(at(1.25, 1.25, 1, 1), 10 * 0.1875 + 20 * (0.1875 + 0.5625));
}

TEST(Fetch, BilinearAtTheSideOfTheFrame) {
  const KeyFrame key = counted(2, 2);
  EXPECT_DOUBLE_EQ(red(key, 0.25, 0.5, Filter::kBilinear), 0);     // the tap outside gives its weight away
  EXPECT_DOUBLE_EQ(red(key, 1.75, 1.0, Filter::kBilinear), 22.5);  // of 10 and 30 the lower one counts as nearest
  EXPECT_DOUBLE_EQ(red(key, -0.25, 1.75, Filter::kBilinear), 20);
  EXPECT_EQ(red(key, -0.49, 0.5, Filter::kBilinear), 0);
  EXPECT_EQ(red(key, -0.5, 0.5, Filter::kBilinear), -1);  // the tap in the frame has no weight
  EXPECT_EQ(red(key, 2.5, 0.5, Filter::kBilinear), -1);
  EXPECT_EQ(red(key, 1e30, -1e30, Filter::kBilinear), -1);
}

TEST(Fetch, BicubicNeedsAllItsTaps) {
  const double by_hand = [] {
    const auto across = cubic_weights(0.25), down = cubic_weights(0.5);
    double sum = 0;
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) sum += across[i] * down[j] * (10 * (4 * j + i));
    }
    return sum;
  }();
  EXPECT_NEAR(red(counted(4, 4), 1.75, 2, Filter::kBicubic), by_hand, 1e-12);
  const KeyFrame without = counted(4, 4, {{3, 0}});
  EXPECT_DOUBLE_EQ(red(without, 1.75, 2, Filter::kBicubic), red(without, 1.75, 2, Filter::kBilinear));
  EXPECT_DOUBLE_EQ(red(counted(4, 4), 1.25, 2, Filter::kBicubic), red(counted(4, 4), 1.25, 2, Filter::kBilinear));
}

TEST(Fetch, OneColourStaysThatColour) {
  for (int others = 0; others < 15; ++others) {
    KeyFrame key = counted(2, 2);
    for (int i = 0; i < 4; ++i) {
      key.identity[i] = others >> i & 1 ? 2 : 1;
      key.colour[i] =
          key.identity[i] == 1 ? std::array<std::uint8_t, 4>{77, 5, 200, 255} : std::array<std::uint8_t, 4>{};
    }
    for (const Filter filter : {Filter::kBilinear, Filter::kArea, Filter::kBicubic}) {
      for (int i = 1; i < 100; ++i) {
        const auto colour = fetch(key, {0.55 + i % 10 / 10.0, 0.5 + i / 100.0}, 1, {filter, true, {true, true}, 0});
        ASSERT_TRUE(colour);
        EXPECT_LT(glm::distance(*colour, glm::dvec3(77, 5, 200)), 1e-12);
      }
    }
  }
}

// --- scenes: a unit is a pixel, (0, 0) the upper left corner of the frame ---

struct Square {
  double x, y, width, height;
  double depth = 0;  // nearer is more
  glm::dvec3 colour{0.8, 0.4, 0.2};
};

// Squares shine by themselves, in one colour or, if there is one, by the texture. A last one, one pixel, stands in the
// corner of the frame: a frame without any triangle is refused.
Scene squares(std::vector<Square> all, const std::optional<Texture>& texture = {}) {
  Scene scene;
  scene.name = "squares";
  scene.camera = Camera{};
  scene.camera->position = {kWidth / 2.0, -kHeight / 2.0, 50};
  scene.camera->orthographic = true, scene.camera->half_height = kHeight / 2.0;
  scene.camera->near = 1, scene.camera->far = 100;
  if (texture) scene.textures = {*texture};
  all.push_back({0, kHeight - 1, 1, 1});
  for (const Square& s : all) {
    Material material;
    material.ambient = material.diffuse = glm::dvec3(0), material.emission = s.colour;
    if (texture) material.texture = 0;
    Mesh mesh;
    mesh.material = int(scene.materials.size());
    for (const auto& [x, y] : {std::pair(0, 1), std::pair(1, 1), std::pair(1, 0), std::pair(0, 0)}) {
      mesh.positions.emplace_back(x * s.width, -y * s.height, 0);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.texture_coordinates.emplace_back(x, y);
    }
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.instances.push_back(
        {int(scene.meshes.size()), glm::translate(glm::dmat4(1), glm::dvec3(s.x, -s.y, s.depth))});
    scene.meshes.push_back(mesh);
    scene.materials.push_back(material);
  }
  return scene;
}

Texture noise(int side) {
  Texture texture{"noise", side, side, {}};
  std::uint32_t state = 1;
  for (int i = 0; i < side * side; ++i) {
    auto& texel = texture.texels.emplace_back();
    for (auto& channel : texel) channel = std::uint8_t((state = state * 1664525u + 1013904223u) >> 24);
  }
  return texture;
}

using At = std::function<Scene(double a)>;
FrameBetween between(const At& scene, double a, const UpConversion& mode) {
  return Interval(scene(0), scene(1), mode).at(scene(a), a);
}
int largest_difference(const Colours& a, const Colours& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[i][c] - b[i][c]));
  }
  return largest;
}
UpConversion with(Filter filter, UpConversion mode = kPlain) {
  mode.compensation.filter = filter;
  return mode;
}

UpConversion surfaces(UpConversion mode) {
  mode.surfaces = true;
  return mode;
}

TEST(Compensate, AStillSceneIsItself) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    for (const bool textured : {false, true}) {
      const At still = [&](double) { return load_scene(name, 0.7, textured); };
      UpConversion mode = kPlain;
      if (textured) mode.texture = TextureMode{};
      for (const Filter filter : kFilters) {
        mode.compensation.filter = filter;
        mode.mapping = filter == Filter::kArea ? VectorMapping::kPerspective : VectorMapping::kLinear;
        mode.relight = filter == Filter::kBicubic;
        mode.surfaces = filter == Filter::kNearest;
        mode.method = filter == Filter::kBilinear ? MotionMethod::kStraight : MotionMethod::kExact;
        const FrameBetween made = between(still, 0.4, mode);
        EXPECT_EQ(made.colour, made.rendered) << name_of(filter);
        EXPECT_EQ(made.shares.filled + made.shares.copied, 0u);
        EXPECT_GT(made.shares.blended, 500u);
      }
    }
  }
}

TEST(Compensate, ASquareMovedByWholePixelsIsItself) {
  const At moved = [](double a) { return squares({{20 + 10 * a, 30 - 20 * a, 50, 40}}, noise(16)); };
  UpConversion mode = kPlain;
  mode.texture = TextureMode{};
  for (const Filter filter : kFilters) {
    const FrameBetween made = between(moved, 0.5, with(filter, mode));
    EXPECT_EQ(made.colour, made.rendered) << name_of(filter);
    EXPECT_EQ(made.shares.blended, 50u * 40 + 1);
    EXPECT_EQ(made.shares.background, std::uint64_t(kWidth * kHeight - 50 * 40 - 1));
  }
  // By half a pixel it is not: the texture is resampled.
  EXPECT_GT(largest_difference(between(moved, 0.55, with(Filter::kBilinear, mode)).colour,
                               between(moved, 0.55, with(Filter::kBilinear, mode)).rendered),
            10);
  mode.field = FieldSize::kHalf;  // from an even pixel to even pixels
  const FrameBetween half = between(
      [](double a) {
        return squares({{20 + 12 * a, 30 - 20 * a, 50, 40}}, noise(16));
      },
      0.5, with(Filter::kBilinear, surfaces(mode)));
  int others = 0;
  for (std::size_t i = 0; i < half.colour.size(); ++i) others += half.colour[i] != half.rendered[i];
  EXPECT_LE(others, 4);  // around the corner's pixel
}

// What a vector for 2 × 2 pixels says of the light it says of all four.
TEST(Compensate, HalfAFieldIsRelitAsWell) {
  const At scene = [](double a) {
    Scene scene = load_scene("castle");
    scene.ambient = glm::dvec3(0.2 + 0.5 * a);
    return scene;
  };
  UpConversion mode = kPlain;
  mode.field = FieldSize::kHalf;
  const auto far_off = [&] {
    const FrameBetween made = between(scene, 0.3, mode);
    int pixels = 0;
    for (std::size_t i = 0; i < made.colour.size(); ++i)
      pixels += std::abs(made.colour[i][1] - made.rendered[i][1]) > 6;
    return pixels;
  };
  mode.compensation.use[1] = false;
  const int dark = far_off();
  mode.relight = true;
  EXPECT_LT(far_off(), dark / 4);
}

TEST(Compensate, BlendsByTime) {
  // From (100, 60, 20) to (200, 61, 0).
  const At scene = [](double a) {
    return squares({{20, 30, 50, 40, 0, glm::mix(glm::dvec3(100, 60, 20), glm::dvec3(200, 61, 0), a) / 255.0}});
  };
  UpConversion mode = kPlain;
  const auto at = [&](double a) { return between(scene, a, mode).colour[50 * kWidth + 40]; };
  EXPECT_EQ(at(0.25), (std::array<std::uint8_t, 4>{125, 60, 15, 255}));
  EXPECT_EQ(at(0.5), (std::array<std::uint8_t, 4>{150, 61, 10, 255}));  // 60.5 goes up
  EXPECT_EQ(at(0.75), (std::array<std::uint8_t, 4>{175, 61, 5, 255}));
  mode.compensation.use[0] = false;
  EXPECT_EQ(at(0.25), (std::array<std::uint8_t, 4>{200, 61, 0, 255}));
  const Colours first{{100, 60, 20, 255}}, second{{201, 61, 0, 255}};
  EXPECT_EQ(temporal_average(first, second)[0], (std::array<std::uint8_t, 4>{151, 61, 10, 255}));
  EXPECT_EQ(repeated(first, second, 0.5), first);
  EXPECT_EQ(repeated(first, second, 0.6), second);
}

TEST(Compensate, EdgesBetweenPixelsBySamples) {
  const At moved = [](double a) { return squares({{20 + 11 * a, 30, 50, 40}}); };  // keys on pixels, 25.5 between
  UpConversion mode = surfaces(kPlain);
  mode.samples = 4;
  const FrameBetween made = between(moved, 0.5, with(Filter::kBilinear, mode));
  EXPECT_EQ(made.colour, made.rendered);
  EXPECT_EQ(made.shares.filled, 0u);
  const auto &out = made.colour[50 * kWidth + 24], &edge = made.colour[50 * kWidth + 25],
             &in = made.colour[50 * kWidth + 26];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(edge[c], (out[c] + in[c]) / 2.0, 1);
  EXPECT_GT(std::abs(in[0] - out[0]), 100);
  mode.field = FieldSize::kPixels;  // all or nothing
  EXPECT_GT(largest_difference(between(moved, 0.5, with(Filter::kBilinear, mode)).colour, made.rendered), 50);
}

// --- what keys do not show ---

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
        {1, glm::scale(glm::rotate(place, 0.5 + kPi * (a - 0.5), glm::dvec3(0, 1, 0)), glm::dvec3(25))});
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

// --- light ---

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

// --- key frames ---

TEST(KeyFrames, MixedPixelsShowNothing) {
  const DrawnFrame frame{4,
                         2,
                         {{10, 0, 0, 255},
                          {20, 0, 0, 255},
                          {1, 1, 1, 255},
                          {1, 1, 1, 255},
                          {30, 0, 0, 255},
                          {42, 0, 0, 255},
                          {1, 1, 1, 255},
                          {2, 2, 2, 255}},
                         {1, 2, 3, 3, 1, 2, 3, 0}};
  const KeyFrame faces = key_frame(frame, 2, {0, 1, 2, 3}), surfaces = key_frame(frame, 2, {0, 7, 7, 8});
  EXPECT_EQ(faces.identity, (std::vector<std::uint32_t>{0, 0}));
  EXPECT_EQ(surfaces.identity, (std::vector<std::uint32_t>{7, 0}));
  EXPECT_EQ(faces.colour[0], (std::array<std::uint8_t, 4>{26, 0, 0, 255}));  // 25.5
  EXPECT_EQ(faces.colour[1], (std::array<std::uint8_t, 4>{1, 1, 1, 255}));   // 1.25
}

TEST(KeyFrames, SurfacesAreSmoothGroupsOfAnInstance) {
  const auto of = [](const char* name) { return surface_identities(load_scene(name)); };
  EXPECT_EQ(of("cube"), (Identities{0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6}));
  const Identities ring = of("ring");
  EXPECT_EQ(*std::max_element(ring.begin(), ring.end()), 1u);
  Scene twice = load_scene("ring");
  twice.instances.push_back(twice.instances[0]);
  EXPECT_EQ(surface_identities(twice).back(), 2u);
  EXPECT_EQ(face_identities(twice).back(), surface_identities(twice).size() - 1);
}

TEST(BoxTexture, LeavesFacesInPlace) {
  for (const std::string& name : animated_scene_names()) {
    const Scene plain = load_scene(name, 0.5), textured = load_scene(name, 0.5, true);
    ASSERT_EQ(plain.meshes.size(), textured.meshes.size());
    for (std::size_t m = 0; m < plain.meshes.size(); ++m) {
      const Mesh &a = plain.meshes[m], &b = textured.meshes[m];
      ASSERT_EQ(a.triangles.size(), b.triangles.size());
      ASSERT_EQ(b.texture_coordinates.size(), b.positions.size());
      for (std::size_t t = 0; t < a.triangles.size(); ++t) {
        for (int v = 0; v < 3; ++v) {
          EXPECT_EQ(a.positions[a.triangles[t][v]], b.positions[b.triangles[t][v]]);
          EXPECT_EQ(a.normals[a.triangles[t][v]], b.normals[b.triangles[t][v]]);
        }
      }
    }
    EXPECT_EQ(surface_identities(plain), surface_identities(textured));
  }
}

}  // namespace
}  // namespace halfspace::ref
