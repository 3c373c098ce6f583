// SPDX-License-Identifier: Apache-2.0
#include "ref/motion/quality.hpp"

#include <algorithm>
#include <cmath>

namespace halfspace::ref {
namespace {

constexpr std::array<double, 3> kLuma{0.299, 0.587, 0.114};

// Adds the squared differences of a pixel.
void add_squares(const std::array<std::uint8_t, 4>& a, const std::array<std::uint8_t, 4>& b,
                 std::array<double, 3>& sum) {
  for (int c = 0; c < 3; ++c) sum[c] += (int(a[c]) - b[c]) * (int(a[c]) - b[c]);
}

std::array<double, 3> mean(std::array<double, 3> sum, double count) {
  for (double& s : sum) s /= count;
  return sum;
}

using Values = std::vector<double>;

Values luma(const Colours& picture) {
  Values y;
  for (const auto& p : picture) y.push_back(kLuma[0] * p[0] + kLuma[1] * p[1] + kLuma[2] * p[2]);
  return y;
}

// Of a size that fits, weights that sum to 1.
std::vector<double> window(int size) {
  constexpr double kSigma = 1.5;
  std::vector<double> weights;
  double sum = 0;
  for (int i = 0; i < size; ++i) {
    const double d = i - (size - 1) / 2.0;
    sum += weights.emplace_back(std::exp(-d * d / (2 * kSigma * kSigma)));
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

// Weighted mean of a·b at each place where the window lies in the picture. One tap of a whole row at a time.
Values windowed(const Values& a, const Values& b, int width, int height, const std::vector<double>& across,
                const std::vector<double>& down) {
  const int columns = width - int(across.size()) + 1, rows = height - int(down.size()) + 1;
  Values line(width), out(std::size_t(columns) * rows, 0);
  for (int y = 0; y < height; ++y) {
    Values means(columns, 0);
    for (int x = 0; x < width; ++x) line[x] = a[std::size_t(y) * width + x] * b[std::size_t(y) * width + x];
    for (std::size_t i = 0; i < across.size(); ++i) {
      for (int x = 0; x < columns; ++x) means[x] += across[i] * line[x + i];
    }
    for (int j = std::max(0, y - rows + 1); j < int(down.size()) && j <= y; ++j) {
      for (int x = 0; x < columns; ++x) out[std::size_t(y - j) * columns + x] += down[j] * means[x];
    }
  }
  return out;
}

}  // namespace

double psnr(double mean_square_error) {
  if (mean_square_error == 0) return kMostDecibels;
  return std::min(kMostDecibels, 10 * std::log10(255.0 * 255 / mean_square_error));
}

double psnr_y(const std::array<double, 3>& mean_square_error) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += kLuma[c] * psnr(mean_square_error[c]);
  return sum;
}

const char* name_of(BlockClass block) {
  constexpr const char* kNames[] = {"very bad", "bad", "fair", "good", "very good"};
  return kNames[int(block)];
}

double ssim(const Colours& picture, const Colours& reference, int width, int height) {
  constexpr int kWindow = 11;
  constexpr double kC1 = 0.01 * 255 * 0.01 * 255, kC2 = 0.03 * 255 * 0.03 * 255;
  const std::vector<double> across = window(std::min(kWindow, width)), down = window(std::min(kWindow, height));
  const Values a = luma(picture), b = luma(reference), one(a.size(), 1);
  const auto moment = [&](const Values& p, const Values& q) { return windowed(p, q, width, height, across, down); };
  const Values mean_a = moment(a, one), mean_b = moment(b, one), aa = moment(a, a), bb = moment(b, b),
               ab = moment(a, b);
  double sum = 0;
  for (std::size_t i = 0; i < aa.size(); ++i) {
    const double mu = mean_a[i] * mean_b[i], squares = mean_a[i] * mean_a[i] + mean_b[i] * mean_b[i];
    const double covariance = ab[i] - mu, variances = aa[i] + bb[i] - squares;
    sum += (2 * mu + kC1) * (2 * covariance + kC2) / ((squares + kC1) * (variances + kC2));
  }
  return sum / double(aa.size());
}

std::optional<double> psnr_y_of(const Colours& picture, const Colours& reference, const std::vector<bool>& pixels) {
  std::array<double, 3> sum{};
  std::size_t count = 0;
  for (std::size_t at = 0; at < pixels.size(); ++at) {
    if (!pixels[at]) continue;
    add_squares(picture[at], reference[at], sum);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return psnr_y(mean(sum, double(count)));
}

Quality quality(const Colours& picture, const Colours& reference, int width, int height) {
  Quality q;
  std::array<double, 3> whole{};
  int blocks = 0;
  for (int top = 0; top < height; top += kBlock) {
    for (int left = 0; left < width; left += kBlock) {
      const int right = std::min(left + kBlock, width), bottom = std::min(top + kBlock, height);
      std::array<double, 3> sum{};
      for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x)
          add_squares(picture[std::size_t(y) * width + x], reference[std::size_t(y) * width + x], sum);
      }
      const double decibels = psnr_y(mean(sum, (right - left) * (bottom - top)));
      const auto border = std::upper_bound(std::begin(kBlockBorders), std::end(kBlockBorders), decibels);
      ++q.blocks[border - std::begin(kBlockBorders)];
      ++blocks;
      for (int c = 0; c < 3; ++c) whole[c] += sum[c];
    }
  }
  for (double& share : q.blocks) share /= blocks;
  whole = mean(whole, double(picture.size()));
  for (int c = 0; c < 3; ++c) q.psnr[c] = psnr(whole[c]);
  q.psnr_y = psnr_y(whole);
  q.ssim = ssim(picture, reference, width, height);
  return q;
}

void MeanQuality::add(const Quality& q) {
  ++frames_;
  for (int c = 0; c < 3; ++c) sum_.psnr[c] += q.psnr[c];
  for (int i = 0; i < kBlockClasses; ++i) sum_.blocks[i] += q.blocks[i];
  sum_.psnr_y += q.psnr_y, sum_.ssim += q.ssim;
}

Quality MeanQuality::mean() const {
  Quality q = sum_;
  for (double& value : q.psnr) value /= frames_;
  for (double& value : q.blocks) value /= frames_;
  q.psnr_y /= frames_, q.ssim /= frames_;
  return q;
}

}  // namespace halfspace::ref
