// SPDX-License-Identifier: Apache-2.0
#include "study/trade/motion_trade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "model/drivers/up_convert.hpp"
#include "ref/error.hpp"
#include "ref/motion/up_convert.hpp"

namespace halfspace::model {
namespace {

ref::Filter filter_of(const Config& c) {
  switch (c.filter) {
    case KeyFilter::kNearest: return ref::Filter::kNearest;
    case KeyFilter::kArea: return ref::Filter::kArea;
    case KeyFilter::kBicubic: return ref::Filter::kBicubic;
    default: return ref::Filter::kBilinear;
  }
}

// Nothing rounded, with the same features.
ref::UpConversion reference_of(const MotionInput& input, const Configuration& colour, const Config& motion) {
  ref::UpConversion mode{input.width, input.height, raster_format(colour)};
  mode.samples = motion.samples;
  mode.method = ref::MotionMethod::kExact;
  mode.mapping = has_perspective(motion) ? ref::VectorMapping::kPerspective : ref::VectorMapping::kLinear;
  mode.compensation.filter = filter_of(motion);
  mode.field = ref::FieldSize::kSamples;
  mode.relight = relights(motion);
  return mode;
}

double decibels(double squares, double values) {
  return squares == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(255.0 * 255 * values / squares);
}

struct Difference {
  double squares = 0;  // of all channels
  std::uint64_t wrong = 0;
  int largest = 0;  // of the others
};

Difference difference(const ref::Colours& a, const ref::Colours& b) {
  Difference result;
  for (std::size_t n = 0; n < a.size(); ++n) {
    int largest = 0;
    for (int c = 0; c < 3; ++c) {
      const int error = std::abs(int(a[n][c]) - int(b[n][c]));
      result.squares += error * error;
      largest = std::max(largest, error);
    }
    if (largest > kWrongLsb) ++result.wrong;
    else result.largest = std::max(result.largest, largest);
  }
  return result;
}

void add(ref::Shares& sum, const ref::Shares& s) {
  sum.background += s.background, sum.blended += s.blended, sum.copied += s.copied, sum.filled += s.filled;
}

}  // namespace

std::uint64_t key_frame_bits(const Config& c) {
  const std::uint64_t pixels =
      std::uint64_t((c.width + c.samples - 1) / c.samples) * std::uint64_t((c.height + c.samples - 1) / c.samples);
  const int faces = c.samples > 1 ? 2 : 1;
  return std::uint64_t(2 * faces) * pixels * std::uint64_t(key_pixel_bits(c));
}

std::vector<ref::FrameBetween> motion_reference(const MotionInput& input, const Configuration& motion) {
  if (input.last - input.first <= input.between) {
    throw ref::Error(fmt::format("frames {} to {}: two keys and {} in between are more: take more frames", input.first,
                                 input.last, input.between));
  }
  const ref::UpConversion mode = reference_of(input, colour_configuration(motion), motion.config());
  std::vector<ref::FrameBetween> frames;
  ref::Scene first = input.at(input.first / input.rate);
  for (int key = input.first; key + input.between + 1 <= input.last; key += input.between + 1) {
    ref::Scene last = input.at((key + input.between + 1) / input.rate);
    ref::Interval interval(first, last, mode);
    for (int n = 1; n <= input.between; ++n)
      frames.push_back(interval.at(input.at((key + n) / input.rate), double(n) / (input.between + 1)));
    first = std::move(last);
  }
  return frames;
}

MotionTrade measure_motion(const MotionInput& input, const Configuration& motion, int lanes,
                           const std::vector<ref::FrameBetween>* reference) {
  const Config config = motion.config();
  const Configuration colour = colour_configuration(motion);
  std::vector<ref::FrameBetween> own;
  if (!reference) own = motion_reference(input, motion), reference = &own;
  KernelUpConverter kernels({input.width, input.height, colour, motion, ref::MotionMethod::kExact, false, lanes});
  const auto scene_of = [&](int frame) { return input.at(frame / input.rate); };
  const double tile_bytes = 64.0 * key_pixel_bits(config) / 8;
  MotionTrade trade;
  trade.worst_psnr = trade.worst_reference_psnr = std::numeric_limits<double>::infinity();
  double squares = 0, reference_squares = 0, key_bytes = 0, word_bytes = 0;
  const double values = 3.0 * input.width * input.height;
  const std::vector<Layout> streams = Compensator(motion).layouts();
  const int word_bits =
      std::find_if(streams.begin(), streams.end(), [](const Layout& l) { return l.stream == "motion"; })->bits;
  ref::Scene first = scene_of(input.first);
  for (int key = input.first; key + input.between + 1 <= input.last; key += input.between + 1) {
    ref::Scene last = scene_of(key + input.between + 1);
    kernels.set_keys(first, last);
    for (int n = 1; n <= input.between; ++n) {
      const ref::Scene between = scene_of(key + n);
      const double a = double(n) / (input.between + 1);
      const KernelFrameBetween made = kernels.at(between, a);
      const ref::FrameBetween& exact = (*reference)[std::size_t(trade.frames)];
      const Difference seen = difference(made.colour, exact.rendered), rounding = difference(made.colour, exact.colour);
      ++trade.frames;
      squares += seen.squares, reference_squares += rounding.squares;
      trade.worst_psnr = std::min(trade.worst_psnr, decibels(seen.squares, values));
      trade.worst_reference_psnr = std::min(trade.worst_reference_psnr, decibels(rounding.squares, values));
      trade.wrong_pixels = std::max(trade.wrong_pixels, rounding.wrong);
      trade.colour_largest = std::max(trade.colour_largest, rounding.largest);
      add(trade.shares, made.shares);
      trade.cycles = std::max<std::uint64_t>(trade.cycles, made.cycles);
      key_bytes += double(made.misses[0] + made.misses[1]) * tile_bytes;
      word_bytes += double(made.words) * word_bits / 8;
    }
    first = std::move(last);
  }
  trade.psnr = decibels(squares, values * trade.frames);
  trade.reference_psnr = decibels(reference_squares, values * trade.frames);
  trade.key_bytes = std::uint64_t(key_bytes / trade.frames);
  trade.word_bytes = std::uint64_t(word_bytes / trade.frames);
  return trade;
}

}  // namespace halfspace::model
