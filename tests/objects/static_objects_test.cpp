// SPDX-License-Identifier: Apache-2.0
// Static objects buffers against the renderer that draws everything: random starts and stops, frame by frame, to the
// bit.
#include <gtest/gtest.h>

#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/error.hpp"
#include "tests/objects/small_scene.hpp"

namespace halfspace::ref {
namespace {

struct Case {
  int buffers;
  bool query;
};

TEST(StaticObjects, EachFrameIsThatOfDrawingEverything) {
  constexpr Case kCases[] = {{1, false}, {1, true}, {7, false}, {7, true}, {3, true}};
  constexpr int kFrames = 3000;
  std::uint64_t states[4] = {}, ties = 0, new_views = 0, shown_moving = 0;
  for (const int depth_bits : {24, 5}) {
    const RasterFormat format = format_of(depth_bits);
    Scene scene = small_scene();
    Motion motion(7 + std::uint64_t(depth_bits));
    motion.begin(scene);
    std::vector<StaticObjects> ours;
    for (const Case& c : kCases)
      ours.emplace_back(scene, format, kWidth, kHeight,
                        options_of(c.buffers, c.query ? visible_pixels : OcclusionQuery()));
    for (int frame = 0; frame < kFrames / 2; ++frame) {
      motion.step(scene);
      motion.move_viewer(scene);
      const bool dimmed = motion.dim(scene);
      const Everything all = draw_everything(scene, format);
      for (std::size_t i = 0; i < ours.size(); ++i) {
        if (dimmed) ours[i].start_anew();
        const FrameWork& work = ours[i].draw();
        ASSERT_EQ(wrong_pixels(scene, all.frame, all.faces, ours[i].picture()), 0)
            << "frame " << frame << ", " << kCases[i].buffers << " S-buffers, query " << kCases[i].query;
        for (int k = 0; k < kCases[i].buffers; ++k)
          ASSERT_TRUE(same_objects(ours[i].static_buffer(k), rebuilt(scene, format, ours[i], k)))
              << "frame " << frame << ", " << k;
        ASSERT_EQ(work.queries, kCases[i].query ? work.started : 0u);
        ASSERT_TRUE(!work.new_view || work.moving == scene.instances.size());
        new_views += i == 0 && work.new_view;
      }
      for (std::uint32_t n = 0; n < scene.instances.size(); ++n) ++states[int(ours[0].state(n))];
      // Pixels where something that stands and something that moves are equally near.
      for (std::uint32_t n = 0; n < scene.instances.size(); ++n) {
        if (ours[0].is_static(n)) continue;
        ours[0].raster().fragments(n, ours[0].picture().frame(), [&](int x, int y, std::uint32_t depth, std::uint32_t) {
          const ObjectPixel& still = ours[0].static_buffer(0).at(x, y);
          ties += still.object() != 0 && still.depth() == depth && ours[0].picture().at(x, y).depth() == depth;
          shown_moving += ours[0].picture().at(x, y).object() == n + 1;
        });
      }
    }
  }
  for (const std::uint64_t count : states) EXPECT_GT(count, 2000u);
  EXPECT_GT(ties, 10000u);
  EXPECT_GT(shown_moving, 100000u);
  EXPECT_GT(new_views, 50u);
  std::printf("SS %lu, SD %lu, DS %lu, DD %lu; %lu ties of S and D, %lu frames from a new viewpoint or in new light\n",
              states[0], states[1], states[2], states[3], ties, new_views);
}

TEST(StaticObjects, DrawWhatMovesAndNothingElse) {
  const RasterFormat format = format_of(24);
  Scene scene = small_scene();
  Motion motion(1);
  motion.begin(scene);
  const std::uint64_t all = scene.instances.size();
  StaticObjects ours(scene, format, kWidth, kHeight, options_of(1, visible_pixels));
  scene.instances[2].to_world = motion.place();
  FrameWork work = ours.draw();
  EXPECT_EQ(work.moving, 1u);
  EXPECT_EQ(work.added, all - 1);
  EXPECT_EQ(ours.state(2), ObjectState::kDD);
  EXPECT_EQ(ours.state(3), ObjectState::kDS);
  work = ours.draw();
  EXPECT_EQ(work.moving, 0u);
  EXPECT_EQ(work.added, 1u);
  EXPECT_EQ(ours.draw().drawn(), 0u);
  EXPECT_EQ(ours.state(2), ObjectState::kSS);
  scene.instances[2].to_world = glm::scale(glm::dmat4(1), glm::dvec3(0.9));
  work = ours.draw();
  EXPECT_EQ(ours.state(2), ObjectState::kSD);
  EXPECT_EQ(work.moving, 1u);
  EXPECT_EQ(work.started, 1u);

  scene.camera->position.x += 0.1;
  work = ours.draw();
  EXPECT_TRUE(work.new_view);
  EXPECT_EQ(work.moving, all);
  EXPECT_EQ(work.added + work.redrawn + work.queries, 0u);
  work = ours.draw();
  EXPECT_FALSE(work.new_view);
  EXPECT_EQ(work.moving, 0u);
  EXPECT_EQ(work.added, all);
  EXPECT_EQ(ours.draw().drawn(), 0u);
}

TEST(StaticObjects, RefuseWhatTheyCannotDo) {
  Scene scene = small_scene();
  EXPECT_THROW(StaticObjects(scene, format_of(0), kWidth, kHeight, {}), Error);
  EXPECT_THROW(StaticObjects(scene, format_of(24), kWidth, kHeight, options_of(0, {})), Error);
  StaticOptions few_bits;
  few_bits.object_bits = 4;  // 15 objects, and there are 17
  EXPECT_THROW(StaticObjects(scene, format_of(24), kWidth, kHeight, few_bits), Error);
  few_bits.object_bits = 5;
  StaticObjects ours(scene, format_of(24), kWidth, kHeight, few_bits);
  scene.instances.pop_back();
  EXPECT_THROW(ours.draw(), Error);
}

}  // namespace
}  // namespace halfspace::ref
