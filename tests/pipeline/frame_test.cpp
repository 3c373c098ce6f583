// SPDX-License-Identifier: Apache-2.0
// Kernels that take a frame at once give what they give by triangles and rows.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "hls/pipeline/front.hpp"
#include "hls/shade/scan_index.hpp"
#include "tests/formats/record_fields.hpp"

namespace halfspace::tests {
namespace {

template <class F>
struct Unit {
  Unit()
      : index(std::make_unique<IndexBuffer<F>>()),
        depth(std::make_unique<DepthBuffer<F>>()),
        planes(std::make_unique<VisibilityDatabase<F>>()) {
    update.tap(&updates);
    visits.tap(&visit_counts);
  }
  std::unique_ptr<IndexBuffer<F>> index;
  std::unique_ptr<DepthBuffer<F>> depth;
  std::unique_ptr<VisibilityDatabase<F>> planes;
  Stream<Triangle<F>> triangle;
  Stream<Setup<F>> setup;
  Stream<Attributes<F>> attributes;
  Stream<Stamp<F>> stamp;
  Stream<TriangleDepth<F>> triangle_depth;
  Stream<Visible<F>> visible;
  Stream<Scan<F>> scan;
  Probe<Update<F>> update;
  Probe<int> visits;
  Probe<PlaneTests> tests;
  std::vector<Update<F>> updates;
  std::vector<int> visit_counts;
};

template <class F>
Frame<F> frame_of(int width, int height) {
  Frame<F> frame{};
  frame.width = from_raw<typename F::X>(width);
  frame.height = from_raw<typename F::Y>(height);
  return frame;
}

constexpr int kTriangles = 400, kWidth = 37, kHeight = 23;

// Some large ones; of the small ones many follow each other in the same stamp.
template <class F>
void write_triangles(std::mt19937& random, Stream<Triangle<F>>& triangle) {
  const int unit = 1 << F::kSubpixelBits;
  const auto below = [&](int n) { return int(random() % unsigned(n)); };
  for (int n = 1; n <= kTriangles; ++n) {
    Triangle<F> t{};
    const int x = below(n % 16 == 0 ? kWidth * unit : 3 * unit), y = below(n % 16 == 0 ? kHeight * unit : 3 * unit),
              size = unit * (n % 16 == 0 ? 12 : 3);
    for (int v = 0; v < 3; ++v) {
      t.x[v] = from_raw<typename F::Coord>(x + below(size));
      t.y[v] = from_raw<typename F::Coord>(y + below(size));
      t.depth[v] = from_raw<typename F::Depth>(below(1 << 12));
    }
    t.index = from_raw<typename F::Index>(n);
    t.last = from_raw<Bit>(n == kTriangles);
    triangle.write(t);
  }
}

// The Z-test of a triangle, and that of a frame.
template <class F>
bool test_triangle(std::false_type, Unit<F>& u) {
  return ztest_index(u.stamp, *u.index, *u.depth, u.update, u.visible);
}
template <class F>
bool test_triangle(std::true_type, Unit<F>& u) {
  return ztest_plane(u.stamp, u.triangle_depth, *u.index, *u.planes, u.update, u.visible, u.tests);
}
template <class F>
void test_frame(std::false_type, Unit<F>& u) {
  ztest_index_frame(u.stamp, *u.index, *u.depth, u.update, u.visible);
}
template <class F>
void test_frame(std::true_type, Unit<F>& u) {
  ztest_plane_frame(u.stamp, u.triangle_depth, *u.index, *u.planes, u.update, u.visible, u.tests);
}

struct GammaLow {
  static constexpr Config config() {
    Config config = Low::config();
    config.architecture = Architecture::kGamma;
    return config;
  }
};

template <class F>
void expect_equal() {
  const Frame<F> frame = frame_of<F>(kWidth, kHeight);
  Unit<F> one, whole;
  std::mt19937 random(5);
  for (int round = 0; round < 3; ++round) {
    const std::mt19937 same = random;
    write_triangles<F>(random, one.triangle);
    random = same;
    write_triangles<F>(random, whole.triangle);
    for (bool last = false; !last;) {
      triangle_setup(frame, one.triangle, one.setup, one.attributes);
      last = raster_pineda(frame, one.setup, one.stamp, one.triangle_depth, one.visits);
      EXPECT_EQ(test_triangle(typename F::CompilesPlaneTest(), one), last);
    }
    for (int n = 0; n < kTriangles; ++n) triangle_setup(frame, whole.triangle, whole.setup, whole.attributes);
    raster_pineda_frame(frame, whole.setup, whole.stamp, whole.triangle_depth, whole.visits);
    test_frame(typename F::CompilesPlaneTest(), whole);
    EXPECT_TRUE(whole.setup.empty() && whole.stamp.empty());
    EXPECT_EQ(whole.visit_counts, one.visit_counts);
    EXPECT_EQ(fields_of(whole.updates), fields_of(one.updates));
    EXPECT_EQ(drain(whole.visible), drain(one.visible));
    for (int y = 0; y * F::kLanesY < kHeight; ++y) scan_index(frame, y, *one.index, one.scan);
    scan_index_frame(frame, *whole.index, whole.scan);
    const std::vector<std::int64_t> scan = drain(whole.scan);
    EXPECT_GT(scan.size(), std::size_t(kWidth * kHeight / F::kLanes));
    EXPECT_EQ(scan, drain(one.scan));
  }
  EXPECT_GT(one.updates.size(), 400u);
}

TEST(Frame, IsItsTrianglesWithOneLane) { expect_equal<Formats<Low, Stamp1>>(); }
TEST(Frame, IsItsTrianglesWithFourLanes) { expect_equal<Formats<Middle, Stamp4>>(); }

TEST(Frame, IsItsTrianglesWithPlanesInTheDatabase) {
  expect_equal<Formats<GammaLow, Stamp1>>();
  expect_equal<Formats<GammaLow, Stamp4>>();
}

}  // namespace
}  // namespace halfspace::tests
