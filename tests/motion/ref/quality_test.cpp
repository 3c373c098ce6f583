// SPDX-License-Identifier: Apache-2.0
// The measures of quality against numbers worked out by hand.
#include "ref/motion/quality.hpp"
#include "ref/motion/compensate.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace halfspace::ref {
namespace {

Colours grey(int width, int height, std::uint8_t level) {
  return Colours(std::size_t(width) * height, {level, level, level, 255});
}

TEST(Psnr, OfAStepEverywhere) {
  Colours off = grey(16, 8, 100);
  for (auto& p : off) p[1] = 101;  // mean square 1 in green alone
  const Quality q = quality(off, grey(16, 8, 100), 16, 8);
  const double of_one = 20 * std::log10(255.0);  // 48.1308
  EXPECT_EQ(q.psnr[0], kMostDecibels);
  EXPECT_NEAR(q.psnr[1], of_one, 1e-12);
  EXPECT_NEAR(q.psnr_y, 0.413 * kMostDecibels + 0.587 * of_one, 1e-12);
  for (auto& p : off) p[0] = 90, p[2] = 103;  // 100 and 9
  EXPECT_NEAR(quality(off, grey(16, 8, 100), 16, 8).psnr_y, of_one - 0.299 * 20 - 0.114 * 10 * std::log10(9.0), 1e-12);
}

TEST(Psnr, IsCapped) {
  EXPECT_EQ(quality(grey(5, 5, 7), grey(5, 5, 7), 5, 5).psnr_y, kMostDecibels);
  EXPECT_LT(psnr(1 / 122000.0), kMostDecibels);  // one step in one of so many pixels
  EXPECT_EQ(psnr(1 / 123000.0), kMostDecibels);
}

TEST(Psnr, OfSomePixelsAlone) {
  Colours picture(4, {10, 20, 30, 255}), reference = picture;
  picture[3] = {20, 30, 40, 255};
  EXPECT_EQ(psnr_y_of(picture, reference, {true, true, true, false}), kMostDecibels);
  EXPECT_NEAR(*psnr_y_of(picture, reference, {false, false, true, true}), psnr(50), 1e-9);
  EXPECT_NEAR(*psnr_y_of(picture, reference, {false, false, false, true}), psnr(100), 1e-9);
  EXPECT_FALSE(psnr_y_of(picture, reference, {false, false, false, false}).has_value());
}

// 2 × 1 pixels of 2 × 2 samples: one with a sample that no key shows, one with samples of keys and of the background.
TEST(MadeOfKeys, IsAPixelWithoutARenderedSample) {
  const std::vector<std::uint32_t> face{1, 1, 1, 0, 1, 1, 0, 0};
  const std::vector<std::uint8_t> keys{1, 0, 3, 0, 2, 1, 0, 0};
  Shares shares;
  EXPECT_EQ(made_of_keys(keys, face, 4, 2, 2, shares), (std::vector<bool>{false, true}));
  EXPECT_EQ(shares.pixels, 2u);
  EXPECT_EQ(shares.rendered, 1u);
  EXPECT_EQ(made_of_keys(keys, face, 4, 2, 1, shares),
            (std::vector<bool>{true, false, true, false, true, true, false, false}));
  EXPECT_EQ(shares.pixels, 2u + 5);
  EXPECT_EQ(shares.rendered, 1u + 1);
}

TEST(Blocks, AreClassedByTheirOwnPsnr) {
  // 10×6 pixels: blocks of 4, 4, 2 columns and 4, 2 rows.
  Colours picture = grey(10, 6, 0);
  const auto fill = [&](int left, int top, int right, int bottom, int level) {
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x)
        picture[std::size_t(y) * 10 + x] = {std::uint8_t(level), std::uint8_t(level), std::uint8_t(level), 255};
    }
  };
  fill(0, 0, 4, 4, 26);   // 255/26: 19.83 dB
  fill(4, 0, 8, 4, 25);   // 20.17
  fill(8, 0, 10, 4, 14);  // 25.21
  fill(0, 4, 4, 6, 8);    // 30.07
  fill(4, 4, 8, 6, 2);    // 42.1
  const Quality q = quality(picture, grey(10, 6, 0), 10, 6);
  EXPECT_NEAR(q.blocks[int(BlockClass::kVeryBad)], 1 / 6.0, 1e-15);
  EXPECT_NEAR(q.blocks[int(BlockClass::kBad)], 1 / 6.0, 1e-15);
  EXPECT_NEAR(q.blocks[int(BlockClass::kFair)], 1 / 6.0, 1e-15);
  EXPECT_NEAR(q.blocks[int(BlockClass::kGood)], 1 / 6.0, 1e-15);
  EXPECT_NEAR(q.blocks[int(BlockClass::kVeryGood)], 2 / 6.0, 1e-15);
}

TEST(Ssim, OfFlatPicturesIsThatOfTheirMeans) {
  const double c1 = 0.01 * 255 * 0.01 * 255;
  EXPECT_NEAR(ssim(grey(20, 20, 50), grey(20, 20, 100), 20, 20), (2 * 50 * 100 + c1) / (50 * 50 + 100 * 100 + c1),
              1e-9);
  EXPECT_NEAR(ssim(grey(4, 30, 50), grey(4, 30, 50), 4, 30), 1, 1e-12);
}

TEST(Ssim, OfStripesAgainstTheirNegative) {
  Colours a = grey(32, 32, 0), b = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::uint8_t light = i % 2 ? 228 : 28;
    a[i] = {light, light, light, 255};
    b[i] = {std::uint8_t(256 - light), std::uint8_t(256 - light), std::uint8_t(256 - light), 255};
  }
  // Means 128 but for the window's ripple, variance 100², covariance −100².
  const double c2 = 0.03 * 255 * 0.03 * 255, expected = (-2e4 + c2) / (2e4 + c2);
  EXPECT_NEAR(ssim(a, b, 32, 32), expected, 1e-3);
  EXPECT_NEAR(ssim(b, a, 32, 32), ssim(a, b, 32, 32), 1e-12);
}

TEST(MeanQuality, IsThatOfFrames) {
  MeanQuality mean;
  mean.add(quality(grey(8, 8, 0), grey(8, 8, 0), 8, 8));
  mean.add(quality(grey(8, 8, 255), grey(8, 8, 0), 8, 8));  // 0 dB
  EXPECT_EQ(mean.frames(), 2);
  EXPECT_NEAR(mean.mean().psnr_y, kMostDecibels / 2, 1e-12);
  EXPECT_NEAR(mean.mean().psnr[2], kMostDecibels / 2, 1e-12);
  EXPECT_EQ(mean.mean().blocks[0], 0.5);
  EXPECT_EQ(mean.mean().blocks[4], 0.5);
}

}  // namespace
}  // namespace halfspace::ref
