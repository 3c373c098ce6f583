// SPDX-License-Identifier: Apache-2.0
// The motion field of the kernels against the reference's, within the bound of each pixel: animated scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/motion/field_fixture.hpp"

namespace halfspace::tests {
namespace {

// The triangles as they are snapped, and where places are planes, these too: what the field is exact of.
ref::Between snapped(ref::Between between, const ref::SnappedList& list, const Config& config) {
  const ref::TriangleList on_grid = ref::unsnap(list);
  for (std::size_t k = 0; k < between.traces.size(); ++k) {
    for (int v = 0; v < 3; ++v) {
      between.list.triangles[k][v].x = on_grid.triangles[k][v].x;
      between.list.triangles[k][v].y = on_grid.triangles[k][v].y;
      for (auto& screen : between.traces[k].screen) {
        for (int axis = 0; screen && !has_perspective(config) && axis < 2; ++axis) {
          double& at = (*screen)[v][axis];
          at = std::ldexp(ref::snapped_position(at, config.subpixel_bits), -config.subpixel_bits);
        }
      }
    }
  }
  return between;
}

void expect_each_pixel_once(const Field& field, int lanes_x, int lanes_y) {
  std::vector<std::pair<int, int>> expected;
  const int width = field.list.width, height = field.list.height;
  for (int y = 0; y < height; y += lanes_y) {
    for (int x = 0; x < width; x += lanes_x) {
      for (int l = 0; l < lanes_x * lanes_y; ++l) {
        const int px = x + l % lanes_x, py = y + l / lanes_x;
        if (px < width && py < height && field.triangle[std::size_t(py) * width + px] != 0)
          expected.emplace_back(px, py);
      }
    }
  }
  std::vector<std::pair<int, int>> found;
  for (const auto& word : field.motion) found.emplace_back(word.x, word.y);
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(found, expected);
}

TEST_P(MotionFieldTest, AnimationsAreWithinTheBound) {
  std::printf("%s: largest error, pixels; its share of the bound of the pixel\n", GetParam());
  double largest_share = 0;
  for (const std::string& name : ref::animated_scene_names()) {
    double largest = 0, share = 0;
    std::size_t compared = 0, beyond = 0;
    for (const double first : {0.0, 0.5, 1.1}) {
      const ref::Between motion = between(name, first, first + 5 / 30.0, 0.4);
      const Field field = drawn(motion);
      expect_each_pixel_once(field, engine_->lanes_x(), engine_->lanes_y());
      const ref::MotionField exact =
          ref::motion_field(snapped(motion, field.list, config_), format_,
                            has_perspective(config_) ? ref::VectorMapping::kPerspective : ref::VectorMapping::kLinear);
      for (const auto& word : field.motion) {
        const std::size_t at = std::size_t(word.y) * field.list.width + word.x;
        const std::uint32_t k = field.triangle[at];
        ASSERT_EQ(int(word.face), model::face_number(motion.traces[k - 1].face, config_));
        if (k != exact.triangle[at]) continue;  // surfaces closer than an LSB of depth
        for (int key = 0; key < ref::kKeys; ++key) {
          const model::RawKeyPlaces& words = field.words.triangles[k - 1].key[key];
          if (!words.there) {
            ASSERT_FALSE(word.key[key].there) << name;
            continue;
          }
          ASSERT_TRUE(exact.to_key[key][at].has_value());
          const Exact at_pixel = exact_at(field.list.triangles[k - 1], words, word.x, word.y, config_);
          const double part = std::max(at_pixel.place.x, at_pixel.place.y);
          const double bound =
              model::motion_bound(config_, words.extent, part, at_pixel.q, at_pixel.distance) +
              model::motion_vertex_bound(config_, words.extent, at_pixel.spread, at_pixel.q, at_pixel.least) + kTiny;
          const glm::dvec2 vector = *exact.to_key[key][at];
          if (!word.key[key].there) {
            ++beyond;
            ASSERT_TRUE(std::max(std::abs(vector.x), std::abs(vector.y)) >= range_ - unit_ - bound) << name;
            continue;
          }
          for (int axis = 0; axis < 2; ++axis) {
            const double error = std::abs((axis ? word.key[key].y : word.key[key].x) * unit_ - vector[axis]);
            ASSERT_LE(error, bound) << name << ", pixel (" << word.x << ", " << word.y << "), key " << key;
            largest = std::max(largest, error);
            share = std::max(share, error / bound);
          }
          ++compared;
        }
      }
    }
    EXPECT_GT(compared, 1000u) << name;
    std::printf("  %-14s %.4f  %.3f  %zu vectors, %zu out of range\n", name.c_str(), largest, share, compared, beyond);
    largest_share = std::max(largest_share, share);
  }
  EXPECT_GT(largest_share, 0.5);  // a bound that is far off says nothing
}

// Planes of the vectors as they are, positions not snapped: two snapped ends more.
TEST_P(MotionFieldTest, AffineFieldsAreThoseOfTheReference) {
  if (has_perspective(config_)) GTEST_SKIP();
  for (const std::string& name : ref::animated_scene_names()) {
    const ref::Between motion = between(name, 0.3, 0.3 + 5 / 30.0, 0.6);
    const Field field = drawn(motion);
    const ref::MotionField exact = ref::motion_field(motion, format_, ref::VectorMapping::kLinear);
    std::size_t compared = 0;
    for (const auto& word : field.motion) {
      const std::size_t at = std::size_t(word.y) * field.list.width + word.x;
      const std::uint32_t k = field.triangle[at];
      if (k != exact.triangle[at]) continue;
      for (int key = 0; key < ref::kKeys; ++key) {
        if (!word.key[key].there) continue;
        const model::RawKeyPlaces& words = field.words.triangles[k - 1].key[key];
        const Exact at_pixel = exact_at(field.list.triangles[k - 1], words, word.x, word.y, config_);
        const double bound = model::motion_bound(config_, words.extent, 1, at_pixel.q, at_pixel.distance) +
                             model::motion_vertex_bound(config_, words.extent, 1, at_pixel.q, at_pixel.least) +
                             std::ldexp(1.0, -config_.subpixel_bits) + kTiny;
        ASSERT_LE(std::abs(word.key[key].x * unit_ - exact.to_key[key][at]->x), bound) << name;
        ASSERT_LE(std::abs(word.key[key].y * unit_ - exact.to_key[key][at]->y), bound) << name;
        ++compared;
      }
    }
    EXPECT_GT(compared, 500u) << name;
  }
}

TEST_P(MotionFieldTest, WhereNothingMovesVectorsAreZero) {
  for (const char* name : {"cube_slow", "wheel_turn", "drone"}) {
    const Field field = drawn(between(name, 0.7, 0.7, 0.5));
    for (const auto& word : field.motion) {
      for (const auto& key : word.key) {
        ASSERT_TRUE(key.there) << name;
        ASSERT_EQ(key.x, 0) << name << ", pixel (" << word.x << ", " << word.y << ")";
        ASSERT_EQ(key.y, 0) << name << ", pixel (" << word.x << ", " << word.y << ")";
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, MotionFieldTest,
                         testing::Values("motion_low", "motion_middle", "motion_high", "motion_gamma"));

}  // namespace
}  // namespace halfspace::tests
