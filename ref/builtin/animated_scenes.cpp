// SPDX-License-Identifier: Apache-2.0
#include "ref/builtin/animated_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/builtin/box_texture.hpp"
#include "ref/builtin/builtin_scenes.hpp"

namespace halfspace::ref {
namespace {

constexpr double kPi = glm::pi<double>();

void move(Scene& scene, const glm::dmat4& motion) {
  for (Instance& instance : scene.instances) instance.to_world = motion * instance.to_world;
}

// Turned at so many degrees a second. The view has room for a whole turn.
Scene spinning(Scene scene, const glm::dvec3& axis, double degrees, double seconds) {
  constexpr int kStops = 24;
  for (int stop = 0; stop < kStops; ++stop) {
    const glm::dmat4 turn = glm::rotate(glm::dmat4(1), 2 * kPi * stop / kStops, axis);
    for (const Instance& instance : scene.instances) {
      for (const glm::dvec3& p : scene.meshes[instance.mesh].positions)
        scene.framing.emplace_back(turn * (instance.to_world * glm::dvec4(p, 1)));
    }
  }
  move(scene, glm::rotate(glm::dmat4(1), glm::radians(degrees) * seconds, axis));
  return scene;
}

constexpr double kSlow = 30, kFast = 180, kWheel = 90;  // degrees a second
const glm::dvec3 kTilted = glm::normalize(glm::dvec3(0.3, 1, 0.2));

Scene cube_slow(double seconds) { return spinning(cube(), kTilted, kSlow, seconds); }
Scene cube_fast(double seconds) { return spinning(cube(), kTilted, kFast, seconds); }
Scene pyramid_slow(double seconds) { return spinning(pyramid(), {0, 1, 0}, kSlow, seconds); }
Scene pyramid_fast(double seconds) { return spinning(pyramid(), {0, 1, 0}, kFast, seconds); }
Scene wheel_turn(double seconds) { return spinning(wheel(), {0, 0, 1}, kWheel, seconds); }

// The camera goes in and out, twice; the cube stands still.
Scene cube_zoom(double seconds) {
  constexpr double kNear = 4.5, kFar = 13;
  Scene scene = cube();
  Camera camera;
  camera.forward = glm::normalize(scene.view_direction);
  camera.position = -glm::mix(kNear, kFar, (1 + std::cos(2 * kPi * seconds)) / 2) * camera.forward;
  camera.half_height = 0.42;
  scene.camera = camera;
  return scene;
}

// Away from the viewer and back, once.
Scene wheel_in_out(double seconds) {
  constexpr double kReach = 3;
  Scene scene = wheel();
  for (const double x : {-1.2, 1.2}) {
    for (const double y : {-1.2, 1.2}) scene.framing.emplace_back(x, y, 0.3);
  }
  const double reach = kReach * (1 - std::cos(kPi * seconds)) / 2;
  move(scene, glm::translate(glm::dmat4(1), reach * glm::normalize(scene.view_direction)));
  return scene;
}

// From rest above the picture's middle to below it, tumbling.
Scene ring_fall(double seconds) {
  constexpr double kDuration = 1.5, kHeight = 2.3, kTumble = 120;
  Scene scene = ring();
  scene.view_direction = {-0.2, -0.15, -1};
  for (const double x : {-1.7, 1.7}) {
    for (const double y : {-1.7, 1.7}) scene.framing.emplace_back(x, y, 0);
  }
  const double part = seconds / kDuration;
  const glm::dmat4 fallen = glm::translate(glm::dmat4(1), glm::dvec3(0, kHeight * (1 - 2 * part * part), 0));
  move(scene, glm::rotate(fallen, glm::radians(30 + kTumble * seconds), glm::normalize(glm::dvec3(1, 0, 0.4))));
  return scene;
}

constexpr struct {
  const char* name;
  double duration;  // seconds
  Scene (*at)(double seconds);
} kAnimations[] = {{"cube_slow", 2, cube_slow},
                   {"cube_fast", 2, cube_fast},
                   {"cube_zoom", 2, cube_zoom},
                   {"pyramid_slow", 2, pyramid_slow},
                   {"pyramid_fast", 2, pyramid_fast},
                   {"wheel_in_out", 2, wheel_in_out},
                   {"wheel_turn", 2, wheel_turn},
                   {"ring_fall", 1.5, ring_fall},
                   {"drone", 2, drone},
                   {"jet", 2, jet},
                   {"court", 3, court}};

}  // namespace

std::vector<std::string> animated_scene_names() {
  std::vector<std::string> names;
  for (const auto& animation : kAnimations) names.push_back(animation.name);
  return names;
}

std::optional<Scene> animated_scene(const std::string& name, double time_seconds, bool textured) {
  for (const auto& known : kAnimations) {
    if (name != known.name) continue;
    Scene scene = known.at(std::clamp(time_seconds, 0.0, known.duration));
    scene.name = name;
    scene.duration = known.duration;
    if (textured) add_box_texture(scene);
    return scene;
  }
  return std::nullopt;
}

}  // namespace halfspace::ref
