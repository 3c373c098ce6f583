// SPDX-License-Identifier: Apache-2.0
// Triangles of a given shape or size that cover a pixel centre of the frame.
#ifndef HALFSPACE_STUDY_STABILITY_STABILITY_TRIANGLES_HPP_
#define HALFSPACE_STUDY_STABILITY_STABILITY_TRIANGLES_HPP_

#include <optional>
#include <random>

#include "hls/formats/config.hpp"
#include "study/bounds/bounds_exact.hpp"

namespace halfspace::model {

class ShapeSource {
 public:
  ShapeSource(const Config& config, std::uint64_t seed) : config_(config), random_(seed) {}

  // Length²/D within 2^(log2 ± ½), the length that of the longest edge: about the frame's width, more where the grid
  // has no such triangle as short. Nothing if none was found.
  std::optional<ref::SnappedTriangle> of_aspect(int log2);
  // In a square box of 2^log2 pixels, the guard band at most, of an aspect ratio up to 8.
  std::optional<ref::SnappedTriangle> of_size(int log2);

 private:
  std::int64_t in(std::int64_t low, std::int64_t high);
  double uniform() { return std::uniform_real_distribution<double>()(random_); }
  bool try_aspect(double length, double aspect, ref::SnappedTriangle& t);
  bool accept(const ref::SnappedTriangle& t, int px, int py) const;
  void colour(ref::SnappedTriangle& t);

  Config config_;
  std::mt19937_64 random_;
};

// Of the longest edge, squared.
double squared_length(const ref::SnappedTriangle& t);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_STABILITY_STABILITY_TRIANGLES_HPP_
