// SPDX-License-Identifier: Apache-2.0
// A small scene whose objects start and stop at random and come to stand in each other's places: what tests of the
// static objects buffer and its vector sets draw.
#ifndef HALFSPACE_VECTORS_FRAMES_MOVING_SCENE_HPP_
#define HALFSPACE_VECTORS_FRAMES_MOVING_SCENE_HPP_

#include <cstdint>
#include <random>
#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::model {

// Up to 16 objects: quads that face the viewer and meet at equal depths, from both sides or one; solids; one smaller
// than a pixel. Each has its own colours, so that no two look alike. After them one more, which is always there, so
// that a frame is never without a triangle.
ref::Scene moving_scene(int objects);

// Chooses who moves, and where to: few places, so that objects meet and come back.
class SceneMotion {
 public:
  SceneMotion(std::uint64_t seed, int objects) : random_(seed), moving_(std::size_t(objects)) {}

  int below(int n) { return int(random_() % std::uint64_t(n)); }
  glm::dmat4 place();
  // Everything somewhere.
  void begin(ref::Scene&);
  // The next frame.
  void step(ref::Scene&);
  // Moves the viewer now and then for some frames.
  void move_viewer(ref::Scene&);
  // Dims the light now and then, and says so.
  bool dim(ref::Scene&);

 private:
  std::mt19937_64 random_;
  std::vector<bool> moving_;
  int frame_ = 0, view_until_ = 0;  // of move_viewer
};

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_MOVING_SCENE_HPP_
