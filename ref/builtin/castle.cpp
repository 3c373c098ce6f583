// SPDX-License-Identifier: Apache-2.0
// A castle of closed solids that stand into each other: many layers of depth behind most pixels. y up,
// metres.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "ref/builtin/builtin_scenes.hpp"
#include "ref/builtin/mesh_builder.hpp"

namespace halfspace::ref {
namespace {

const glm::dvec3 kUp(0, 1, 0);
const glm::dvec3 kStone(0.72, 0.68, 0.60), kDarkStone(0.58, 0.54, 0.50), kKeepStone(0.80, 0.72, 0.58);
const glm::dvec3 kSlate(0.30, 0.38, 0.50), kTile(0.66, 0.30, 0.22), kPlaster(0.85, 0.80, 0.70),
    kShade(0.16, 0.14, 0.13);
const glm::dvec3 kGrass(0.36, 0.47, 0.26), kCourt(0.62, 0.56, 0.46);

class Mason {
 public:
  MeshBuilder builder;

  // Stones differ a little, by a generator of our own so that the scene is the same everywhere.
  void colour(const glm::dvec3& base) {
    seed_ = seed_ * 1664525u + 1013904223u;
    builder.colour = base * (0.90 + 0.20 * (seed_ >> 24) / 255.0);
  }

  // A wall from one foot to another, with merlons along its left side.
  void wall(const glm::dvec3& from, const glm::dvec3& to, double height, double thickness, const glm::dvec3& stone) {
    const double length = glm::distance(from, to);
    const glm::dvec3 along = (to - from) / length, across = glm::cross(along, kUp);  // to the right
    colour(stone);
    builder.block(from - across * (thickness / 2), along * length, kUp * height, across * thickness);
    const int merlons = int(length / 1.6);
    const double pitch = length / merlons;
    for (int i = 0; i < merlons; ++i) {
      colour(stone);
      builder.block(from - across * (thickness / 2) + along * ((i + 0.25) * pitch) + kUp * height, along * (pitch / 2),
                    kUp * 0.9, across * 0.6);
    }
  }

  // Four walls around a centre.
  void court(double half, double height, double thickness, const glm::dvec3& stone) {
    const glm::dvec3 corners[4] = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
    for (int i = 0; i < 4; ++i) wall(corners[i], corners[(i + 1) % 4], height, thickness, stone);
  }

  void tower(const glm::dvec3& foot, double radius, double height, const glm::dvec3& stone) {
    constexpr int kSides = 16, kMerlons = 8;
    const double top = radius + 0.45;
    colour(stone);
    builder.lathe(foot, {{radius + 0.5, 0}, {radius, 2}, {radius, height - 1.2}, {top, height - 0.6}, {top, height}},
                  kSides);
    builder.disc(foot + kUp * height, top, kSides, true);
    for (int i = 0; i < kMerlons; ++i) {
      const double angle = 2 * glm::pi<double>() * (i + 0.5) / kMerlons;
      const glm::dvec3 outward(std::cos(angle), 0, std::sin(angle)), along = glm::cross(outward, kUp);
      const double width = 0.4 * top;
      colour(stone);
      builder.block(foot + kUp * height + outward * (top - 0.6) + along * (width / 2), -along * width, kUp * 0.9,
                    outward * 0.5);
    }
  }

  void spire(const glm::dvec3& foot, double radius, double height, double roof, const glm::dvec3& stone) {
    constexpr int kSides = 16;
    colour(stone);
    builder.lathe(foot, {{radius + 0.3, 0}, {radius, 2}, {radius, height}}, kSides);
    colour(kSlate);
    builder.disc(foot + kUp * height, radius + 0.5, kSides, false);
    builder.lathe(foot, {{radius + 0.5, height}, {0, height + roof}}, kSides);
  }

  // A house with its ridge along x.
  void house(const glm::dvec3& low, const glm::dvec3& size, double roof) {
    colour(kPlaster);
    builder.box(low, low + size);
    const double eaves = 0.4;
    const glm::dvec3 a = low + glm::dvec3(-eaves, size.y, -eaves), length(size.x + 2 * eaves, 0, 0);
    const glm::dvec3 b = a + glm::dvec3(0, 0, size.z + 2 * eaves), ridge = (a + b) / 2.0 + kUp * roof;
    colour(kTile);
    builder.polygon({b, b + length, ridge + length, ridge});
    builder.polygon({a + length, a, ridge, ridge + length});
    builder.polygon({a, a + length, b + length, b});
    builder.polygon({a, b, ridge});
    builder.polygon({b + length, a + length, ridge + length});
    builder.colour = kShade;
    builder.box(low + glm::dvec3(size.x * 0.4, 0, size.z), low + glm::dvec3(size.x * 0.6, size.y * 0.7, size.z + 0.05));
  }

  void ground(double half, int fields) {
    const double side = 2 * half / fields;
    for (int i = 0; i < fields; ++i) {
      for (int j = 0; j < fields; ++j) {
        const double x = -half + i * side, z = -half + j * side;
        const bool inner = std::abs(x + side / 2) < 20.5 && std::abs(z + side / 2) < 20.5;
        colour(inner ? kCourt : kGrass);
        builder.polygon({{x, 0, z}, {x, 0, z + side}, {x + side, 0, z + side}, {x + side, 0, z}});
      }
    }
  }

  void keep() {
    constexpr double kHalf = 4.5, kHeight = 15;
    court(kHalf, kHeight, 1.2, kKeepStone);
    colour(kKeepStone);
    builder.box({-kHalf, 0, -kHalf}, {kHalf, kHeight - 0.5, kHalf});
    for (const double x : {-kHalf, kHalf}) {
      for (const double z : {-kHalf, kHalf}) spire({x, 0, z}, 1.5, kHeight + 3, 4.5, kKeepStone);
    }
    builder.colour = kShade;
    for (const double y : {4.0, 8.0, 12.0}) {
      for (const double x : {-2.0, 0.0, 2.0}) {
        builder.box({x - 0.35, y, kHalf + 0.5}, {x + 0.35, y + 1.5, kHalf + 0.65});
        builder.box({kHalf + 0.5, y, x - 0.35}, {kHalf + 0.65, y + 1.5, x + 0.35});
      }
    }
  }

  void gatehouse() {
    tower({-3.6, 0, 22}, 2.2, 10, kDarkStone);
    tower({3.6, 0, 22}, 2.2, 10, kDarkStone);
    wall({3.6, 0, 22.5}, {-3.6, 0, 22.5}, 8.5, 2.5, kDarkStone);
    builder.colour = kShade;
    builder.box({-1.4, 0, 23.6}, {1.4, 4.5, 23.85});
    colour({0.50, 0.36, 0.22});
    builder.box({-1.5, 0.02, 23.85}, {1.5, 0.3, 26.4});
  }

 private:
  std::uint32_t seed_ = 7;
};

}  // namespace

Scene castle() {
  constexpr double kOuter = 21, kInner = 11;
  Mason mason;
  mason.ground(26.4, 12);
  mason.court(kOuter, 5.5, 1.8, kStone);
  mason.court(kInner, 8, 1.6, kKeepStone);
  for (const double x : {-kOuter, 0.0, kOuter}) {
    for (const double z : {-kOuter, 0.0, kOuter}) {
      if (x != 0 || (z != 0 && z != kOuter)) mason.tower({x, 0, z}, 2.4, x != 0 && z != 0 ? 9.5 : 8, kStone);
    }
  }
  for (const double x : {-kInner, kInner}) {
    for (const double z : {-kInner, kInner}) mason.spire({x, 0, z}, 1.9, 11, 5, kDarkStone);
  }
  mason.gatehouse();
  mason.keep();
  mason.house({-18, 0, 13.5}, {7, 3, 4}, 2.2);
  mason.house({10.5, 0, 13.5}, {6, 3.4, 4.5}, 2.4);
  mason.house({13, 0, 4}, {5, 3, 4}, 2);
  mason.house({13.2, 0, -8}, {5, 4, 5}, 2.6);
  mason.house({-18, 0, -4}, {5, 3, 5}, 2);
  mason.house({-8, 0, 5.6}, {5, 3, 3.6}, 1.8);
  mason.house({4, 0, -9.4}, {5, 3, 3.6}, 1.8);

  Material stone;
  stone.ambient = stone.diffuse = glm::dvec3(1);
  Scene scene = std::move(mason.builder).scene(stone);
  scene.ambient = {0.38, 0.39, 0.44};
  scene.background = {92, 122, 158};
  scene.view_direction = {-0.42, -0.38, -1};
  return scene;
}

}  // namespace halfspace::ref
