// SPDX-License-Identifier: Apache-2.0
// How far a picture is from another, as frame-rate up-conversion measures it.
#ifndef HALFSPACE_REF_MOTION_QUALITY_HPP_
#define HALFSPACE_REF_MOTION_QUALITY_HPP_

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace halfspace::ref {

// r, g, b, 255; width · height pixels, row 0 on top.
using Colours = std::vector<std::array<std::uint8_t, 4>>;

// A channel's PSNR in dB, of the mean square error in steps of 255; at most kMostDecibels, so that what is equal can be
// averaged. One step in one of 122,000 pixels is as good.
constexpr double kMostDecibels = 99;
double psnr(double mean_square_error);

// 0.299·PSNR_R + 0.587·PSNR_G + 0.114·PSNR_B.
double psnr_y(const std::array<double, 3>& mean_square_error);

// Classes of blocks by their PSNR_Y: from each border on the next one. The borders are ours.
enum class BlockClass { kVeryBad, kBad, kFair, kGood, kVeryGood };
constexpr int kBlockClasses = 5;
constexpr double kBlockBorders[kBlockClasses - 1] = {20, 25, 30, 40};
constexpr int kBlock = 4;         // pixels each way; what is left at the right and at the bottom is a smaller one
const char* name_of(BlockClass);  // "very bad", …

// Of one frame, or a mean over frames.
struct Quality {
  std::array<double, 3> psnr{};  // R, G, B
  double psnr_y = 0;
  double ssim = 0;                             // of Y
  std::array<double, kBlockClasses> blocks{};  // shares, which sum to 1
};

Quality quality(const Colours& picture, const Colours& reference, int width, int height);

// PSNR_Y of these pixels alone; none where there are none.
std::optional<double> psnr_y_of(const Colours& picture, const Colours& reference, const std::vector<bool>& pixels);

// Y = 0.299·R + 0.587·G + 0.114·B. Structural similarity with the usual window (Gaussian, 11×11, σ = 1.5) and constants
// (0.01·255)², (0.03·255)², meaned over the places where the window lies in the picture; the window is smaller in a
// picture that is.
double ssim(const Colours& picture, const Colours& reference, int width, int height);

// Mean over frames.
class MeanQuality {
 public:
  void add(const Quality&);
  int frames() const { return frames_; }
  Quality mean() const;

 private:
  Quality sum_;
  int frames_ = 0;
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_QUALITY_HPP_
