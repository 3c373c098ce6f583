// SPDX-License-Identifier: Apache-2.0
// The occlusion query skips what is not needed and nothing else; a broken one leaves ghosts.
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "tests/objects/small_scene.hpp"

namespace halfspace::ref {
namespace {

// Every object that starts to move, with what its S-buffer showed of it a frame before.
TEST(StaticObjects, QuerySkipsWhatIsNotNeededAndNothingElse) {
  const RasterFormat format = format_of(24);
  for (const int buffers : {1, 3}) {
    Scene scene = small_scene();
    Motion motion(99);
    motion.begin(scene);
    std::vector<std::pair<std::uint32_t, bool>> answers;  // object, skipped
    const OcclusionQuery query = [&](const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
      const std::uint64_t count = buffer.count(object, box);
      answers.emplace_back(object, count == 0);
      return count;
    };
    StaticObjects ours(scene, format, kWidth, kHeight, options_of(buffers, query));
    std::uint64_t needed = 0, unneeded = 0, skipped = 0;
    ours.draw();
    for (int frame = 0; frame < 2000; ++frame) {
      std::vector<ObjectBuffer> before;
      for (int k = 0; k < buffers; ++k) before.push_back(rebuilt(scene, format, ours, k));
      std::vector<bool> by_drawing;  // seen, as the Z-test counts it
      for (std::uint32_t n = 0; n < scene.instances.size(); ++n)
        by_drawing.push_back(ours.is_static(n) &&
                             ours.raster().count_equal(n, ours.static_buffer(ours.buffer_of(n))) != 0);
      motion.step(scene);
      answers.clear();
      ours.draw();
      for (const auto& [object, skip] : answers) {
        const ObjectBuffer& buffer = before[ours.buffer_of(object - 1)];
        const bool need = buffer.count(object, buffer.frame()) != 0;
        ASSERT_EQ(by_drawing[object - 1], need);
        ++(need ? needed : unneeded);
        ASSERT_FALSE(need && skip) << "frame " << frame << ", object " << object;
        skipped += skip;
      }
    }
    std::printf("%d S-buffers: %lu updates needed, %lu not, of which %lu skipped\n", buffers, needed, unneeded,
                skipped);
    EXPECT_GT(needed, 500u);
    EXPECT_GT(unneeded, 200u);
    EXPECT_GE(double(skipped), 0.95 * double(unneeded));
  }
}

// Frames that come out wrong with a query that answers as `broken` does.
int wrong_frames(int buffers, const std::function<OcclusionQuery(const StaticObjects*&)>& broken) {
  const RasterFormat format = format_of(24);
  Scene scene = small_scene();
  Motion motion(5);
  motion.begin(scene);
  const StaticObjects* asked = nullptr;
  StaticObjects ours(scene, format, kWidth, kHeight, options_of(buffers, broken(asked)));
  asked = &ours;
  int wrong = 0;
  for (int frame = 0; frame < 300; ++frame) {
    motion.step(scene);
    const Everything all = draw_everything(scene, format);
    ours.draw();
    wrong += wrong_pixels(scene, all.frame, all.faces, ours.picture()) != 0;
  }
  return wrong;
}

TEST(StaticObjects, BrokenQueriesLeaveGhosts) {
  EXPECT_EQ(wrong_frames(1, [](auto&) { return visible_pixels; }), 0);
  // The picture in the place of the S-buffer: what a moving object hides now is a ghost when that has gone.
  const auto picture = [](const StaticObjects*& asked) {
    return [&asked](const ObjectBuffer&, std::uint32_t object, const Box& box) {
      return asked->picture().count(object, box);
    };
  };
  EXPECT_GT(wrong_frames(1, picture), 0);
  EXPECT_GT(wrong_frames(7, picture), 0);
  // Few pixels taken for none.
  EXPECT_GT(wrong_frames(1,
                         [](auto&) {
                           return [](const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
                             return buffer.count(object, box) / 8;
                           };
                         }),
            0);
  // Not the whole box.
  EXPECT_GT(wrong_frames(1,
                         [](auto&) {
                           return [](const ObjectBuffer& buffer, std::uint32_t object, const Box& box) {
                             return buffer.count(object, {box.x0, box.y0, box.x1, box.y1 - 1});
                           };
                         }),
            0);
}

}  // namespace
}  // namespace halfspace::ref
