// SPDX-License-Identifier: Apache-2.0
// The stability study: at every aspect ratio and size the kernels keep their proved bound, and what stands beside them
// behaves as its arithmetic says.
#include <gtest/gtest.h>

#include <cmath>

#include "model/formats/configuration.hpp"
#include "study/stability/plane_models.hpp"
#include "study/stability/stability.hpp"
#include "study/stability/stability_triangles.hpp"

namespace halfspace::tests {
namespace {

using model::StabilityPoint;

class Stability : public testing::TestWithParam<const char*> {};

TEST_P(Stability, OfTheKernelsDoesNotDependOnTheShape) {
  const Config config = model::find_configuration(GetParam()).config();
  model::StabilityOptions options;
  options.triangles = 60;
  const model::StabilityStudy study = model::stability_study(config, options);
  ASSERT_EQ(study.aspect.size(), 31u);
  EXPECT_GE(study.reachable, std::min(30, 2 * (config.range_bits + config.subpixel_bits)));
  for (const auto* points : {&study.aspect, &study.size}) {
    for (const StabilityPoint& p : *points) {
      SCOPED_TRACE(p.log2);
      EXPECT_EQ(p.triangles, points == &study.aspect && p.log2 > study.reachable ? 0u : 60u);
      EXPECT_GE(p.pixels, p.triangles);
      EXPECT_LE(p.depth.largest[model::kKernelPlane], study.depth_bound);
      EXPECT_LE(p.colour.largest[model::kKernelPlane], study.colour_bound);
      EXPECT_EQ(p.depth.beyond[model::kKernelPlane], 0u);
    }
  }
  // Float32 has 24 bits: where an aspect ratio takes them all, nothing is left.
  const StabilityPoint& long_one = study.aspect.at(26);
  for (const auto method : {model::kFloatFromOrigin, model::kFloatFromVertex, model::kSaturatedGradients}) {
    EXPECT_GT(long_one.depth.largest[method], std::ldexp(0.5, config.depth_bits)) << model::plane_method_name(method);
  }
  EXPECT_GT(study.size.front().depth.largest[model::kFloatFromOrigin],
            10 * study.size.back().depth.largest[model::kFloatFromOrigin]);
}

INSTANTIATE_TEST_SUITE_P(Configurations, Stability, testing::Values("low", "middle", "high"));

// What the pictures name on their axes.
TEST(ShapeSource, GivesWhatItSays) {
  const Config config = model::find_configuration("middle").config();
  model::ShapeSource source(config, 7);
  const double one = 1 << config.subpixel_bits;
  for (int log2 = 0; log2 <= 36; log2 += 3) {
    const auto t = source.of_aspect(log2);
    ASSERT_TRUE(t) << log2;
    const model::ExactTriangle exact(*t, config.subpixel_bits);
    EXPECT_LE(std::fabs(std::log2(model::squared_length(*t) / double(exact.area())) - log2), 0.5);
  }
  EXPECT_FALSE(source.of_aspect(44)) << "D >= 1 ends at twice the square of the guard band";
  for (int log2 = -2; log2 <= config.range_bits; ++log2) {
    const auto t = source.of_size(log2);
    ASSERT_TRUE(t) << log2;
    const auto [left, right] = std::minmax({t->x[0], t->x[1], t->x[2]});
    const auto [top, bottom] = std::minmax({t->y[0], t->y[1], t->y[2]});
    EXPECT_NEAR(right - left, std::ldexp(one, log2), 1);
    EXPECT_NEAR(bottom - top, std::ldexp(one, log2), 1);
  }
}

// A triangle on which every float operation is exact, and one gradient of which is beyond what saturates.
TEST(PlaneModels, AreExactWhereFloat32Is) {
  ref::SnappedTriangle t{};
  t.x = {128, 128 + 16 * 256, 128}, t.y = {128, 128, 128 + 16 * 256};
  const model::ExactTriangle exact(t, 8);
  const model::Values values = {0, 15 * 17, 0};
  const model::FloatPlane plane(exact, values, 8, 8);
  EXPECT_NEAR(plane.from_origin(8, 0), 127.5, 1e-4);
  EXPECT_NEAR(plane.from_vertex(8, 4), 127.5, 1e-4);
  EXPECT_EQ(model::SaturatedPlane(exact, values, 8, 8, 10).value(8, 4), 127.5);
  // Full scale within a quarter of a pixel: 1020 LSB a pixel, cut to 512.
  t.x[1] = 128 + 64;
  const model::ExactTriangle steep(t, 8);
  EXPECT_EQ(model::SaturatedPlane(steep, values, 8, 8, 10).value(0, 0), 0);
  EXPECT_EQ(model::SaturatedPlane(steep, {0, 100, 0}, 8, 8, 10).value(1, 0), 255) << "400 LSB, full scale as stored";
}

}  // namespace
}  // namespace halfspace::tests
