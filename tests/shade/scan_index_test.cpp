// SPDX-License-Identifier: Apache-2.0
// Scan-out of every size of frame that a small configuration has, with each stamp: what is in the I-buffer goes out
// stamp by stamp, `last` ends the frame and nothing else, and nothing is left.
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "hls/shade/scan_index.hpp"

namespace halfspace::tests {
namespace {

struct Small {
  static constexpr Config config() { return {"small", 13, 11, 200, 6, 1, 3, 2, 8, 7, 7, 1, Shading::kGouraud}; }
};

template <class S>
class Scans {
 public:
  using F = Formats<Small, S>;

  void expect_frame(int width, int height, bool at_once) {
    for (auto& stamp : stored_) {
      for (int& index : stamp) index = int(random_() % 201);
    }
    for (int n = 0; n < F::kStamps; ++n) {
      for (int l = 0; l < F::kLanes; ++l) buffer_->index[n][l] = from_raw<typename F::Index>(stored_[n][l]);
    }
    Frame<F> frame{};
    frame.width = from_raw<typename F::X>(width);
    frame.height = from_raw<typename F::Y>(height);
    const int columns = (width + S::kX - 1) / S::kX, rows = (height + S::kY - 1) / S::kY;
    if (at_once) scan_index_frame(frame, *buffer_, scan_);
    for (int y = 0; y < rows; ++y) {
      if (!at_once) scan_index(frame, y, *buffer_, scan_);
      for (int x = 0; x < columns; ++x) {
        ASSERT_FALSE(scan_.empty());
        const Scan<F> word = scan_.read();
        ASSERT_EQ(int(raw(word.x)), x);
        ASSERT_EQ(int(raw(word.y)), y);
        ASSERT_EQ(is_set(word.last), x == columns - 1 && y == rows - 1) << x << ", " << y;
        for (int l = 0; l < F::kLanes; ++l) ASSERT_EQ(int(raw(word.index[l])), stored_[y * F::kStampsX + x][l]);
      }
      ASSERT_TRUE(at_once || scan_.empty());
    }
    ASSERT_TRUE(scan_.empty());
    for (int n = 0; n < F::kStamps; ++n) {
      const bool taken = n % F::kStampsX < columns && n / F::kStampsX < rows;
      for (int l = 0; l < F::kLanes; ++l) ASSERT_EQ(int(raw(buffer_->index[n][l])), taken ? 0 : stored_[n][l]);
    }
  }

 private:
  std::unique_ptr<IndexBuffer<F>> buffer_ = std::make_unique<IndexBuffer<F>>();
  int stored_[F::kStamps][F::kLanes];
  Stream<Scan<F>> scan_;
  std::mt19937 random_{9};
};

template <class S>
void expect_all() {
  Scans<S> scans;
  for (int width = 1; width <= 13; ++width) {
    for (int height = 1; height <= 11; ++height) {
      for (const bool at_once : {false, true}) {
        SCOPED_TRACE(testing::Message() << width << "x" << height << (at_once ? " at once" : " by rows"));
        scans.expect_frame(width, height, at_once);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  }
}

TEST(ScanIndex, SendsFramesOfEverySizeWithOneLane) { expect_all<Stamp1>(); }
TEST(ScanIndex, SendsFramesOfEverySizeWithTwoLanes) { expect_all<Stamp2>(); }
TEST(ScanIndex, SendsFramesOfEverySizeWithFourLanes) { expect_all<Stamp4>(); }
TEST(ScanIndex, SendsFramesOfEverySizeWithEightLanes) { expect_all<Stamp8>(); }
TEST(ScanIndex, SendsFramesOfEverySizeWithSixteenLanes) { expect_all<Stamp16>(); }

}  // namespace
}  // namespace halfspace::tests
