// SPDX-License-Identifier: Apache-2.0
// The crowd of the experiment: how many move, and what a frame of it takes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "model/pipeline/cycles.hpp"
#include "ref/builtin/crowd.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/objects/object_raster.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::ref {
namespace {

TEST(Crowd, KeepsItsNumberMovingAndInView) {
  CrowdOptions options;
  options.objects = 400;
  options.layers = 10;
  options.interval = 20;
  Crowd crowd(options), again(options);
  const RasterFormat format{"static", 160, 120, 1 << 20, 11, 8, 24};
  int starts = 0;
  std::vector<glm::dmat4> before(400);
  for (int frame = 0; frame < 400; ++frame) {
    const int wanted = frame < 200 ? 30 : 60;
    for (int n = 0; n < 400; ++n) before[n] = crowd.scene().instances[n].to_world;
    crowd.step(wanted);
    again.step(wanted);
    int moved = 0;
    for (int n = 0; n < 400; ++n) {
      moved += crowd.scene().instances[n].to_world != before[n];
      ASSERT_EQ(crowd.scene().instances[n].to_world, again.scene().instances[n].to_world);
    }
    ASSERT_EQ(moved, wanted);
    starts += frame > 0 && frame != 200 ? crowd.starts() : 0;
  }
  EXPECT_NEAR(starts, 400 * 45 / 20.0, 150);
  ObjectRaster raster(crowd.scene(), format, 160, 120);
  ObjectBuffer buffer(160, 120, full_depth(24));
  for (std::uint32_t n = 0; n < 400; ++n) {
    Box box;
    const Drawn drawn = raster.fragments(n, buffer.frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t) {
      box.add(x, y);
      ASSERT_LT(depth, full_depth(24));
    });
    ASSERT_FALSE(box.empty()) << n;
    ASSERT_GT(drawn.triangles, 500u);
  }
  EXPECT_THROW(crowd.step(200), Error);
}

// The setup units set the pace of small triangles, so that their cycles add up to a frame, but for waits.
TEST(Crowd, CyclesOfAFrameAreThoseOfItsSetup) {
  CrowdOptions options;
  options.objects = 7;
  options.layers = 0.04;  // as large as in the experiment
  const Crowd crowd(options);
  const model::Configuration middle = model::find_configuration("middle");
  const RasterFormat format = model::raster_format(middle);
  SnappedList list = snap(project(crowd.scene(), {640, 480, format.range_bits, format.subpixel_bits}), format);
  const auto engine = model::make_engine("middle", 4);
  const model::Cycles modelled = model::model_cycles(middle.config(), *engine, list, render(list));
  const model::SetupModel model(middle.config(), 640, 480);
  std::uint64_t triangle_setup = 0, shade_setup = 0;
  for (const SnappedTriangle& t : list.triangles) {
    const model::SetupCycles cycles = model.cycles(t);
    triangle_setup += std::uint64_t(cycles.triangle_setup), shade_setup += std::uint64_t(cycles.shade_setup);
  }
  EXPECT_EQ(triangle_setup, modelled.triangle_setup);
  EXPECT_EQ(shade_setup, modelled.shade_setup);
  const double slowest = double(std::max(triangle_setup, shade_setup));
  std::printf("%zu triangles: %lu cycles of triangle setup, %lu of shade setup, %lu of the rasterizer; a frame %lu\n",
              list.triangles.size(), triangle_setup, shade_setup, modelled.raster, modelled.frame);
  EXPECT_LT(double(modelled.raster), 0.5 * slowest);
  EXPECT_NEAR(double(modelled.frame) / slowest, 1, 0.1);
}

}  // namespace
}  // namespace halfspace::ref
