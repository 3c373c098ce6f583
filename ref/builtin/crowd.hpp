// SPDX-License-Identifier: Apache-2.0
// A scene of many objects of which few move: the experiment of the static objects buffer. Objects are instances of
// three meshes of 4,512 triangles, at random places and turned at random, as many before each other everywhere in the
// frame.
#ifndef HALFSPACE_REF_BUILTIN_CROWD_HPP_
#define HALFSPACE_REF_BUILTIN_CROWD_HPP_

#include <cstdint>
#include <random>
#include <vector>

#include "ref/scene/scene.hpp"

namespace halfspace::ref {

struct CrowdOptions {
  int objects = 40000;
  double layers = 250;    // objects that a line of sight meets, about: it gives their size
  double interval = 300;  // frames that an object moves, on average: each number up to twice that is as likely
  std::uint64_t seed = 1;
  double aspect = 4 / 3.0;  // of the frame
};

class Crowd {
 public:
  explicit Crowd(const CrowdOptions&);

  // With depth planes that hold wherever objects go. All are in view.
  const Scene& scene() const { return scene_; }
  // The next frame: those that move go on; who has moved for its time stops, and another one is chosen, so that so
  // many move.
  void step(int moving);
  int starts() const { return starts_; }  // objects that began to move in the last step

 private:
  struct Mover {
    std::uint32_t object;
    glm::dvec3 step;  // a frame
    int left;         // frames
  };
  double uniform(double low, double high);
  glm::dvec3 direction();
  void choose(int frames);
  bool holds(const glm::dvec3& place) const;
  void move(Mover&);

  const CrowdOptions options_;
  std::mt19937_64 random_;
  double radius_;
  Scene scene_;
  std::vector<Mover> movers_;
  std::vector<bool> moves_;
  int starts_ = 0;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_BUILTIN_CROWD_HPP_
