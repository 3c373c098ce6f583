// SPDX-License-Identifier: Apache-2.0
// The motion field against rays that are cast pixel by pixel, and its fixed-point form within its bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/motion/ref/rays.hpp"

namespace halfspace::ref {
namespace {

TEST(Field, AgreesWithRays) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    Seen worst;
    for (const double start : {0.1, 0.6, 1.1}) {
      const Seen seen = compare_with_rays(times(name, start, 0.4));
      EXPECT_LT(seen.perspective, 1e-6);
      EXPECT_GT(seen.vectors, 500);
      EXPECT_EQ(seen.absent, 0);
      worst.perspective = std::max(worst.perspective, seen.perspective),
      worst.linear = std::max(worst.linear, seen.linear);
      worst.vectors += seen.vectors;
    }
    std::printf("%-14s %7d vectors: perspective-correct within %.1e pixels, planes within %.4f\n", name.c_str(),
                worst.vectors, worst.perspective, worst.linear);
  }
}

// Snapping moves either end by half a sub-pixel at most, the vertex's vector is rounded once, the pixel's once more.
TEST(Field, FixedWithinItsBound) {
  const VectorFormat vector_format{9, 4};
  const double bound = std::ldexp(1, -kFormat.subpixel_bits) + std::ldexp(1, -vector_format.fraction_bits);
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    const Between between = times(name, 0.6, 0.4).follow(MotionMethod::kExact);
    const MotionField linear = motion_field(between, kFormat, VectorMapping::kLinear);
    const FixedMotionField fixed = motion_field(between, kFormat, vector_format);
    EXPECT_EQ(fixed.triangle, linear.triangle);
    double off = 0;
    for (std::size_t i = 0; i < fixed.face.size(); ++i) {
      for (int key = 0; fixed.face[i] != 0 && key < kKeys; ++key) {
        for (int axis = 0; axis < 2; ++axis)
          off = std::max(
              off, std::abs(std::ldexp(fixed.to_key[key][i].value()[axis], -4) - linear.to_key[key][i].value()[axis]));
      }
    }
    EXPECT_LE(off, bound);
    EXPECT_GT(off, bound / 4);
    std::printf("%-14s s%d.%d off by %.4f pixels of %.4f\n", name.c_str(), vector_format.range_bits,
                vector_format.fraction_bits, off, bound);
  }
}

}  // namespace
}  // namespace halfspace::ref
