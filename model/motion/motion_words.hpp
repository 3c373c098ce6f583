// SPDX-License-Identifier: Apache-2.0
// The motion of a pixel of a frame in between, as plain numbers.
#ifndef HALFSPACE_MODEL_MOTION_MOTION_WORDS_HPP_
#define HALFSPACE_MODEL_MOTION_MOTION_WORDS_HPP_

#include <array>
#include <cstdint>

namespace halfspace::model {

struct RawKeyVector {
  bool there = false;
  int x = 0, y = 0;                 // multiples of 2^−vector_fraction pixels in between
  std::array<int, 3> difference{};  // with relight: the colour in between less the key's, in 2^−kDifferenceFraction
};

struct RawMotion {
  int x = 0, y = 0;  // in pixels in between
  std::uint32_t face = 0;
  std::array<RawKeyVector, 2> key;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_MOTION_MOTION_WORDS_HPP_
