// SPDX-License-Identifier: Apache-2.0
// The numerical extremes (vectors/frames/extremes.hpp), kernels against the reference: every frame, and every triangle
// of it in a frame of its own. docs/extremes.md has the promises and the numbers that this test prints.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "model/formats/field_value.hpp"
#include "model/pipeline/engine.hpp"
#include "study/trade/accuracy.hpp"
#include "vectors/frames/extremes.hpp"

namespace halfspace::tests {
namespace {

using model::NamedFrame;
using ref::SnappedList;
using ref::SnappedTriangle;

// Triangles without area fill up the frame of the last index: nobody draws them one by one.
constexpr std::size_t kMostAlone = 200;

class Extremes : public testing::TestWithParam<const char*> {
 protected:
  const ref::RasterFormat format_ = model::raster_format(GetParam());
};

struct Measured {
  std::uint64_t triangles = 0, pixels = 0, index_differ = 0, visible_differ = 0, depth_differ = 0, colour_differ = 0;
  std::int64_t depth = 0, colour = 0;  // the largest differences, LSB

  void add(const ref::Frame& reference, const ref::Frame& kernels, int depth_bits) {
    const model::Accuracy a = model::accuracy(reference, kernels, depth_bits);
    pixels += a.compared;
    index_differ += a.index_differ;  // coverage is among it
    depth_differ += a.depth_differ, colour_differ += a.colour_differ;
    depth = std::max(depth, a.depth_largest), colour = std::max(colour, a.colour_largest);
    for (std::size_t k = 0; k < reference.visible.size(); ++k) {
      visible_differ += reference.visible[k] != kernels.visible[k];
    }
  }
};

TEST_P(Extremes, KernelsAgreeWithTheReference) {
  const auto engine = model::make_engine(GetParam(), 4);
  for (const model::ExtremeClass& one : model::extreme_classes()) {
    Measured measured;
    const std::vector<NamedFrame> frames = one.frames(format_);
    for (const NamedFrame& frame : frames) {
      SCOPED_TRACE(frame.note);
      Measured here;
      here.add(ref::render(frame.scene), engine->render(frame.scene), format_.depth_bits);
      SnappedList alone = frame.scene;
      if (frame.scene.triangles.size() > kMostAlone) alone.triangles.clear();
      for (const SnappedTriangle& triangle : std::vector<SnappedTriangle>(std::move(alone.triangles))) {
        alone.triangles = {triangle};
        here.add(ref::render(alone), engine->render(alone), format_.depth_bits);
      }
      EXPECT_EQ(here.index_differ, 0u);
      EXPECT_EQ(here.visible_differ, 0u);
      EXPECT_LE(here.depth, 1);
      EXPECT_LE(here.colour, 1);
      measured.triangles += frame.scene.triangles.size();
      measured.pixels += here.pixels, measured.index_differ += here.index_differ;
      measured.depth_differ += here.depth_differ, measured.colour_differ += here.colour_differ;
      measured.depth = std::max(measured.depth, here.depth), measured.colour = std::max(measured.colour, here.colour);
    }
    EXPECT_GT(measured.pixels, 0u) << one.name;
    std::printf(
        "%-7s %-30s %3zu frames %7llu triangles %8llu pixels: index %llu, depth %lld LSB (%.2f %%), "
        "colour %lld LSB (%.2f %%)\n",
        GetParam(), one.name, frames.size(), static_cast<unsigned long long>(measured.triangles),
        static_cast<unsigned long long>(measured.pixels), static_cast<unsigned long long>(measured.index_differ),
        static_cast<long long>(measured.depth), 100 * double(measured.depth_differ) / double(measured.pixels),
        static_cast<long long>(measured.colour), 100 * double(measured.colour_differ) / 3 / double(measured.pixels));
  }
}

// Any rotation and either winding, with any stamp: the same pixels, to the bit.
TEST_P(Extremes, OrdersAndStampsGiveIdenticalPixels) {
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  std::vector<std::unique_ptr<model::Engine>> engines;
  for (const int lanes : {4, 1, 16}) engines.push_back(model::make_engine(GetParam(), lanes));
  std::size_t triangles = 0;
  for (const NamedFrame& frame : model::extreme_frames(format_)) {
    SCOPED_TRACE(frame.note);
    SnappedList alone = frame.scene;
    for (const SnappedTriangle& triangle : frame.scene.triangles) {
      alone.triangles = {triangle};
      const ref::Frame first = engines[0]->render(alone);
      for (int n = 1; n < 6; ++n) {
        for (int v = 0; v < 3; ++v) {
          const int from = kOrders[n][v];
          SnappedTriangle& to = alone.triangles[0];
          to.x[v] = triangle.x[from], to.y[v] = triangle.y[from];
          to.depth[v] = triangle.depth[from], to.rgb[v] = triangle.rgb[from];
        }
        const ref::Frame other = engines[n % engines.size()]->render(alone);
        ASSERT_EQ(first.index, other.index) << "order " << n;
        ASSERT_EQ(first.depth, other.depth) << "order " << n;
        ASSERT_EQ(first.colour, other.colour) << "order " << n;
      }
      ++triangles;
    }
  }
  EXPECT_GT(triangles, 200u);
}

TEST_P(Extremes, EqualDepthsComeBackExactly) {
  const auto engine = model::make_engine(GetParam(), 4);
  std::size_t covered = 0;
  for (const NamedFrame& frame : model::equal_depth_frames(format_)) {
    const std::uint32_t depth = frame.scene.triangles.at(0).depth[0];
    const ref::Frame kernels = engine->render(frame.scene);
    for (std::size_t n = 0; n < kernels.index.size(); ++n) {
      if (kernels.index[n] == 0) continue;
      ++covered;
      ASSERT_EQ(kernels.depth[n], depth) << frame.note;
    }
  }
  EXPECT_GT(covered, 500u);
}

// A half sub-pixel goes to the even neighbour, and what is a hair off it to the nearer one.
TEST_P(Extremes, TiesGoToTheEvenSubpixel) {
  const ref::TriangleList list = model::finer_than_the_grid(format_);
  const SnappedList snapped = ref::snap(list, format_);
  int ties = 0;
  for (std::size_t k = 0; k < list.triangles.size(); ++k) {
    for (int v = 0; v < 3; ++v) {
      const double position[2] = {std::ldexp(list.triangles[k][v].x, format_.subpixel_bits),
                                  std::ldexp(list.triangles[k][v].y, format_.subpixel_bits)};
      const std::int32_t got[2] = {snapped.triangles[k].x[v], snapped.triangles[k].y[v]};
      for (int axis = 0; axis < 2; ++axis) {
        const double off = std::fabs(position[axis] - got[axis]);
        EXPECT_LE(off, 0.5);
        if (off != 0.5) continue;
        ++ties;
        EXPECT_EQ(got[axis] % 2, 0) << position[axis];
      }
    }
  }
  EXPECT_GT(ties, 40);
}

// The set is what it says: of every field of every stream it needs the top bit.
TEST_P(Extremes, EveryFieldNeedsItsTopBit) {
  const auto engine = model::make_engine(GetParam(), 1);
  struct Range {
    model::Field field;
    std::int64_t low = 0, high = 0;
  };
  std::map<std::string, Range> ranges;
  for (const model::ExtremeClass& one : model::extreme_classes()) {
    for (const NamedFrame& frame : one.frames(format_)) {
      // The words of the largest frame would fill the memory.
      if (frame.scene.width * frame.scene.height > 100000) continue;
      engine->capture(frame.scene, [&](const model::Layout& layout, const model::Word* words, std::size_t count) {
        for (const model::Field& field : layout.fields) {
          Range& range = ranges[layout.stream + "." + field.name];
          range.field = field;
          for (std::size_t n = 0; n < count; ++n) {
            const std::int64_t value = model::field_value(words[n], field);
            range.low = std::min(range.low, value), range.high = std::max(range.high, value);
          }
        }
      });
    }
  }
  EXPECT_GT(ranges.size(), 50u);
  for (const auto& [name, range] : ranges) {
    const std::int64_t top = std::int64_t(1) << (range.field.width - (range.field.is_signed ? 2 : 1));
    const bool needed = range.high >= top || range.low < -top;
    EXPECT_TRUE(needed) << name << " of " << range.field.width << " bits: " << range.low << " to " << range.high;
  }
}

INSTANTIATE_TEST_SUITE_P(Configurations, Extremes, testing::Values("low", "middle", "high"));

}  // namespace
}  // namespace halfspace::tests
