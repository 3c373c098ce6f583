// SPDX-License-Identifier: Apache-2.0
// Motion fields of words as no scene has them, and the ends of formats.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/formats/field_value.hpp"
#include "tests/motion/field_fixture.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/frames/extremes.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

// A triangle that is moved as it is, by the same way to both keys.
class OneTriangle : public MotionFieldTest {
 protected:
  ref::Between moved(const glm::dvec2& way) const {
    ref::Between motion;
    motion.list = {64, 48, {0, 0, 0}, {}, {}};
    const glm::dvec2 corner[3] = {{10, 8}, {40, 12}, {20, 40}};
    ref::Trace trace{7, true, {1, 1, 1}, {}, {}};
    std::array<ref::Vertex, 3> triangle;
    for (int v = 0; v < 3; ++v) triangle[v] = {corner[v].x, corner[v].y, 0.5, 0, 0, 0};
    for (auto& screen : trace.screen) {
      screen.emplace();
      for (int v = 0; v < 3; ++v) (*screen)[v] = corner[v] + way;
    }
    motion.list.triangles.push_back(triangle);
    motion.list.face.push_back(7);
    motion.traces.push_back(trace);
    return motion;
  }
};

TEST_P(OneTriangle, VectorsReachTheEndsOfTheirRange) {
  const double last = range_ - unit_, guard = std::ldexp(1.0, config_.range_bits - 1);
  struct Case {
    double way;
    bool there;
  };
  for (const Case& one :
       {Case{last, true}, Case{range_, false}, Case{-range_, true}, Case{-range_ - unit_, false}, Case{guard, false}}) {
    for (const glm::dvec2& way : {glm::dvec2(one.way, 0), glm::dvec2(0, one.way)}) {
      const Field field = drawn(moved(way));
      ASSERT_GT(field.motion.size(), 100u);
      for (const auto& word : field.motion) {
        EXPECT_EQ(word.face, 7u);
        for (const auto& key : word.key) {
          ASSERT_EQ(key.there, one.there) << one.way;
          ASSERT_EQ(key.x, one.there ? int(way.x / unit_) : 0);
          ASSERT_EQ(key.y, one.there ? int(way.y / unit_) : 0);
        }
      }
    }
  }
}

// Nearer than the near plane at one key: no vectors to that one, whatever the other has.
TEST_P(OneTriangle, KeysAreThereOrNotEachForItself) {
  for (int key = 0; key < ref::kKeys; ++key) {
    ref::Between motion = moved({3, -2});
    motion.traces[0].screen[key].reset();
    for (const auto& word : drawn(motion).motion) {
      ASSERT_FALSE(word.key[key].there);
      ASSERT_EQ(word.key[key].x, 0);
      ASSERT_TRUE(word.key[1 - key].there);
      ASSERT_EQ(word.key[1 - key].x, int(3 / unit_));
      ASSERT_EQ(word.key[1 - key].y, int(-2 / unit_));
    }
  }
}

TEST_P(OneTriangle, FaceNumbersBeginAgain) {
  const std::uint32_t faces = (1u << config_.face_bits) - 1;
  EXPECT_EQ(model::face_number(1, config_), 1);
  EXPECT_EQ(model::face_number(faces, config_), int(faces));
  EXPECT_EQ(model::face_number(faces + 1, config_), 1);
}

// A frame whose last stamp is background ends with a word of face 0, and one without a triangle is that word alone.
TEST_P(OneTriangle, TheEndOfAFrameIsAWord) {
  const Field field = drawn(moved({1, 1}));
  ref::SnappedList none = field.list;
  none.triangles.clear();
  for (const bool drawn : {true, false}) {
    engine_->move(drawn ? field.words : model::MotionFrame{});
    std::size_t words = 0, lasts = 0, of_no_face = 0;
    engine_->capture(drawn ? field.list : none,
                     [&](const model::Layout& layout, const model::Word* word, std::size_t count) {
                       if (layout.stream != "motion") return;
                       words = count;
                       for (std::size_t n = 0; n < count; ++n) {
                         const bool last = model::field_value(word[n], model::field_named(layout, "last")) != 0;
                         lasts += last;
                         of_no_face += model::field_value(word[n], model::field_named(layout, "face")) == 0;
                         EXPECT_EQ(last, n + 1 == count);
                       }
                     });
    EXPECT_EQ(words, (drawn ? field.motion.size() : 0) + 1);
    EXPECT_EQ(lasts, 1u);
    EXPECT_EQ(of_no_face, 1u);
  }
}

// Words as no scene has them, on triangles of all kinds, slivers among them: against the exact planes of the words.
TEST_P(MotionFieldTest, AwkwardWordsAreWithinTheBound) {
  std::vector<model::NamedFrame> frames = model::sliver_frames(format_);
  for (auto& frame : model::random_frames(format_, 3, 4, 60)) frames.push_back(std::move(frame));
  double share = 0, difference_share = 0;
  std::size_t compared = 0, out_of_range = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const ref::SnappedList& list = frames[n].scene;
    const Field field = field_of(*engine_, list, model::awkward_motion(list, config_, n + 1));
    for (const auto& word : field.motion) {
      const std::uint32_t k = field.triangle[std::size_t(word.y) * list.width + word.x];
      for (int key = 0; key < ref::kKeys; ++key) {
        const model::RawKeyPlaces& words = field.words.triangles[k - 1].key[key];
        if (!words.there) {
          ASSERT_FALSE(word.key[key].there);
          continue;
        }
        const Exact exact = exact_at(list.triangles[k - 1], words, word.x, word.y, config_);
        const double bound = model::motion_bound(config_, words.extent, std::max(exact.place.x, exact.place.y), exact.q,
                                                 exact.distance) +
                             kTiny;
        const glm::dvec2 vector = glm::dvec2(words.origin_x, words.origin_y) +
                                  exact.place * std::ldexp(1.0, words.extent) - glm::dvec2(word.x + 0.5, word.y + 0.5);
        if (!word.key[key].there) {
          ++out_of_range;
          ASSERT_GE(std::max(std::abs(vector.x), std::abs(vector.y)), range_ - unit_ - bound);
          continue;
        }
        for (int axis = 0; axis < 2; ++axis) {
          const double error = std::abs((axis ? word.key[key].y : word.key[key].x) * unit_ - vector[axis]);
          ASSERT_LE(error, bound) << frames[n].note << ", pixel (" << word.x << ", " << word.y << ")";
          share = std::max(share, error / bound);
        }
        ++compared;
        if (!relights(config_)) continue;
        const ref::OrderedTriangle t(list.triangles[k - 1]);
        const int s = config_.subpixel_bits;
        const auto weight = ref::vertex_weights(t, ref::pixel_centre(word.x, s), ref::pixel_centre(word.y, s));
        for (int c = 0; c < 3; ++c) {
          double difference = -std::ldexp(1.0, difference_bits(config_) - 1);
          for (int v = 0; v < 3; ++v) difference += weight[v] * words.difference[c][v];
          const double error = std::abs(word.key[key].difference[c] - difference);
          const double limit = model::difference_bound(config_, exact.distance) + kTiny;
          ASSERT_LE(error, limit);
          difference_share = std::max(difference_share, error / limit);
        }
      }
    }
  }
  std::printf("%s: awkward words, %.3f of the bound at most, differences %.3f; %zu vectors, %zu out of range\n",
              GetParam(), share, difference_share, compared, out_of_range);
  EXPECT_GT(compared, 1000u);
  EXPECT_GT(out_of_range, 0u);
  EXPECT_GT(share, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Configurations, MotionFieldTest,
                         testing::Values("motion_low", "motion_middle", "motion_high", "motion_gamma"));
INSTANTIATE_TEST_SUITE_P(Configurations, OneTriangle,
                         testing::Values("motion_low", "motion_middle", "motion_high", "motion_gamma"));

}  // namespace
}  // namespace halfspace::tests
