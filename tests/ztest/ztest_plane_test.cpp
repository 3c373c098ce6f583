// SPDX-License-Identifier: Apache-2.0
// What ztest_plane leaves in TdbV, and what its stamps cost.
#include <gtest/gtest.h>

#include <memory>

#include "hls/ztest/ztest_plane.hpp"

namespace halfspace::tests {
namespace {

struct Small {
  static constexpr Config config() {
    return {"small", 8, 8, 7, 6, 1, 4, 2, 10, 8, 8, 4, Shading::kGouraud, Architecture::kGamma};
  }
};
using F = Formats<Small, Stamp4>;

class ZtestPlane : public testing::Test {
 protected:
  ZtestPlane() {
    tests_.tap(&costs_);
    update_.tap(&updates_);
    for (auto& entry : database_->entry) entry = plane(kMark);
  }

  // Of depth `depth` everywhere, in units of its last place.
  static DepthEntry<F> plane(int depth) {
    DepthEntry<F> entry{};
    entry.origin = from_raw<F::DepthPlane>(depth << Small::config().depth_fraction);
    return entry;
  }
  static int depth_of(const DepthEntry<F>& entry) { return int(raw(entry.origin)) >> Small::config().depth_fraction; }

  void send_plane(int index, int depth) {
    TriangleDepth<F> word{};
    word.index = from_raw<F::Index>(index);
    word.depth = plane(depth).origin;
    depth_plane_.write(word);
  }
  void send_stamp(int index, int x, int mask, int depth, bool triangle_last, bool last = false) {
    Stamp<F> word{};
    word.index = from_raw<F::Index>(index);
    word.x = from_raw<F::X>(x);
    for (int l = 0; l < F::kLanes; ++l) {
      word.mask[l] = from_raw<Bit>(mask >> l);
      word.depth[l] = from_raw<F::Depth>(depth);
    }
    word.triangle_last = from_raw<Bit>(triangle_last);
    word.last = from_raw<Bit>(last);
    stamp_.write(word);
  }
  // Whether the triangle is visible.
  bool test() {
    last_ = ztest_plane(stamp_, depth_plane_, *index_, *database_, update_, visible_, tests_);
    return is_set(visible_.read().visible);
  }

  static constexpr int kMark = 13;
  std::unique_ptr<IndexBuffer<F>> index_ = std::make_unique<IndexBuffer<F>>();
  std::unique_ptr<VisibilityDatabase<F>> database_ = std::make_unique<VisibilityDatabase<F>>();
  Stream<Stamp<F>> stamp_;
  Stream<TriangleDepth<F>> depth_plane_;
  Stream<Visible<F>> visible_;
  Probe<Update<F>> update_;
  Probe<PlaneTests> tests_;
  std::vector<PlaneTests> costs_;
  std::vector<Update<F>> updates_;
  bool last_ = false;
};

TEST_F(ZtestPlane, LeavesNothingOfAnInvisibleTriangle) {
  send_plane(1, 3);
  send_stamp(1, 0, 0xf, 3, true);
  EXPECT_TRUE(test());
  EXPECT_EQ(depth_of(database_->entry[0]), 3);
  EXPECT_FALSE(last_);
  // As deep as what is there, and deeper.
  for (const int depth : {3, 9}) {
    send_plane(2, depth);
    send_stamp(2, 0, 0xf, depth, true, depth == 9);
    EXPECT_FALSE(test());
    EXPECT_EQ(depth_of(database_->entry[1]), kMark);
  }
  EXPECT_TRUE(last_);
  // Nearer, where the mask has no pixel.
  send_plane(2, 1);
  send_stamp(2, 0, 0, 1, true);
  EXPECT_FALSE(test());
  EXPECT_EQ(depth_of(database_->entry[1]), kMark);
  EXPECT_EQ(updates_.size(), 1u);
}

TEST_F(ZtestPlane, LeavesThePlaneWithTheFirstFragment) {
  send_plane(1, 3);
  send_stamp(1, 0, 0xf, 3, true);
  test();
  send_plane(2, 5);
  send_stamp(2, 0, 0xf, 5, false);
  send_stamp(2, 1, 0x4, 5, true);
  EXPECT_TRUE(test());
  EXPECT_EQ(depth_of(database_->entry[1]), 5);
  ASSERT_EQ(updates_.size(), 2u);
  for (int l = 0; l < F::kLanes; ++l) EXPECT_EQ(is_set(updates_[1].mask[l]), l == 2);
  // One nobody sees after one that is seen.
  send_plane(3, 6);
  send_stamp(3, 0, 0xf, 6, true);
  EXPECT_FALSE(test());
  EXPECT_EQ(depth_of(database_->entry[2]), kMark);
}

// A cycle for the plane, and one for each triangle under the covered lanes, or for a stamp with none.
TEST_F(ZtestPlane, CountsTheTrianglesUnderAStamp) {
  for (int index = 1; index <= 3; ++index) {
    send_plane(index, 8);
    send_stamp(index, 0, 1 << index, 8, true);
    EXPECT_TRUE(test());
  }
  send_plane(4, 2);
  send_stamp(4, 0, 0xe, 2, false);
  send_stamp(4, 1, 0xf, 2, true);
  EXPECT_TRUE(test());
  send_plane(5, 1);
  send_stamp(5, 0, 0xf, 1, true);
  EXPECT_TRUE(test());
  const int cycles[] = {2, 2, 2, 5, 2}, entries[] = {0, 0, 0, 3, 1};
  ASSERT_EQ(costs_.size(), 5u);
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(costs_[n].cycles, cycles[n]) << n;
    EXPECT_EQ(costs_[n].entries, entries[n]) << n;
  }
}

}  // namespace
}  // namespace halfspace::tests
