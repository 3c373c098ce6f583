// SPDX-License-Identifier: Apache-2.0
// Frames for motion_compensate alone, each with what it is for: neither pictures nor anything that moves.
#ifndef HALFSPACE_VECTORS_FRAMES_COMPENSATION_FRAMES_HPP_
#define HALFSPACE_VECTORS_FRAMES_COMPENSATION_FRAMES_HPP_

#include <string>
#include <vector>

#include "model/motion/compensation.hpp"

namespace halfspace::model {

struct NamedCompensation {
  std::string note;
  int width = 0, height = 0;
  std::array<KeyFrame, 2> key;
  std::vector<RawMotion> motion;
  int weight = 0;
  bool by_tiles = true;

  CompensationInput input() const { return {width, height, {&key[0], &key[1]}, motion, weight, by_tiles}; }
};

std::vector<NamedCompensation> compensation_frames(const Config& config, std::uint64_t seed);

// `words` pixels of key frames of four tiles: a cache that has them misses nothing more.
NamedCompensation warm_frame(const Config& config, int words, std::uint64_t seed);

// The frame in between that has this motion field, in its order, and key frames of which most of its vectors find their
// face.
NamedCompensation between_frame(const Config& config, int width, int height, std::vector<RawMotion> motion,
                                std::uint64_t seed);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_COMPENSATION_FRAMES_HPP_
