// SPDX-License-Identifier: Apache-2.0
// Triangles to measure errors on: random ones of several classes, and ones built to be as bad as they can be.
#ifndef HALFSPACE_STUDY_BOUNDS_BOUNDS_TRIANGLES_HPP_
#define HALFSPACE_STUDY_BOUNDS_BOUNDS_TRIANGLES_HPP_

#include <cstdint>
#include <random>
#include <vector>

#include "hls/formats/config.hpp"
#include "ref/geometry/snap.hpp"
#include "study/proofs/bounds_proved.hpp"

namespace halfspace::model {

enum class TriangleClass { kSmall, kAny, kHuge, kFrameSliver, kGuardBandSliver, kCorner };
constexpr TriangleClass kTriangleClasses[] = {
    TriangleClass::kSmall,           TriangleClass::kAny,   TriangleClass::kHuge, TriangleClass::kFrameSliver,
    TriangleClass::kGuardBandSliver, TriangleClass::kCorner};
const char* class_name(TriangleClass kind);

class TriangleSource {
 public:
  TriangleSource(const Config& config, std::uint64_t seed) : config_(config), random_(seed) {}

  ref::SnappedTriangle next(TriangleClass kind);

  // A sliver from the first corner of the guard band or of the frame to the pixel in the opposite corner of the frame,
  // which lies between the two other vertices, with values from end to end: all that a bound adds up.
  ref::SnappedTriangle farthest(Vertices vertices);
  // The same with one of its numbers changed a little.
  ref::SnappedTriangle changed(const ref::SnappedTriangle& t, Vertices vertices);

 private:
  std::int64_t in(std::int64_t low, std::int64_t high);
  std::int32_t clamped(std::int64_t position) const;
  std::uint32_t any_value(int bits);

  Config config_;
  std::mt19937_64 random_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_TRIANGLES_HPP_
