// SPDX-License-Identifier: Apache-2.0
// Extremes of planes. b: bits of a channel; A, B: its gradients; R: the reciprocal.
#include <fmt/format.h>

#include <cmath>

#include "vectors/frames/extremes.hpp"
#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;

namespace {

// A compact triangle of any D >= 1 with its middle at a point: (0, 0), (q, 1), (rest, h) have q·h − rest = D.
void add_area(FrameBuilder& b, std::int64_t area, int x, int y) {
  std::int64_t h = std::int64_t(std::sqrt(double(area)));
  while (h * h < area) ++h;
  const std::int64_t q = (area + h - 1) / h, rest = q * h - area;
  const int left = int(std::clamp<std::int64_t>(x - (q + rest) / 3, b.low(), b.high() - q));
  const int top = int(std::clamp<std::int64_t>(y - (1 + h) / 3, b.low(), b.high() - h));
  b.add({left, top}, {left + int(q), top + 1}, {left + int(rest), top + int(h)});
}

}  // namespace

std::vector<NamedFrame> reciprocal_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  const int f = format.subpixel_bits, c = format.range_bits + f, small = 2 * f + 1;
  {
    // Up to two square pixels, side by side.
    FrameBuilder b(format, 30, 3 * ((3 * small + 12) / 10));
    int n = 0;
    for (int k = 2; k <= small; ++k) {
      for (int more = -1; more <= 1; ++more, ++n) {
        add_area(b, (std::int64_t(1) << k) + more, b.centre(n % 10 * 3 + 1), b.centre(n / 10 * 3 + 1));
      }
    }
    push_frame(frames,
               "extreme: D = 2^k − 1, 2^k, 2^k + 1 in a pixel: the ends of s; R = 2^r exactly, and its lower end", b);
  }
  for (int k = small + 1; k < 2 * c; ++k) {
    FrameBuilder b(format, 8, 4);
    // The largest first and nearest last, so that all are drawn; of the last the picture shows every pixel.
    for (const int more : {-1, 1, 0}) {
      add_area(b, (std::int64_t(1) << k) + more, b.centre(3), b.centre(1));
      const std::uint32_t d = b.full_depth() / 8;
      more<0 ? b.depth(6 * d, 7 * d, 6 * d) : more> 0 ? b.depth(3 * d, 4 * d, 5 * d) : b.depth(0, d, 2 * d);
    }
    push_frame(frames,
               fmt::format("extreme: D = 2^{0} − 1, 2^{0} + 1, 2^{0}: s = {1} and {0}; R = 2^r exactly", k, k - 1), b);
  }
  {
    // D = q·S − rest = 2^k with a side as high as the guard band.
    FrameBuilder b(format, 12, 8);
    const std::int64_t side = std::int64_t(b.high()) - b.low();
    for (const int k : {c, c + 2, 2 * c - 2}) {
      const std::int64_t area = std::int64_t(1) << k, q = (area + side - 1) / side, rest = q * side - area;
      const int left = int(std::max<std::int64_t>(b.low(), b.centre(5) - rest / 2 - q / 4));
      b.add({left, b.low()}, {left + int(q), b.low() + 1}, {left + int(rest), b.high()}).swing(1);
    }
    push_frame(frames, "extreme: |N| = (2^b − 1)·S times R = 2^r: the largest product of a gradient", b);
  }
  return frames;
}

std::vector<NamedFrame> gradient_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  for (const bool turned : {false, true}) {
    const char* along = turned ? "B" : "A";
    {
      FrameBuilder b(format, 36, 28, turned);
      const int half = b.half(), wide[6] = {2 * half + 2, 3 * half, 4 * half, 5 * half, 6 * half, 8 * half};
      for (int n = 0; n < 12; ++n) {
        const int x = b.centre(n % 6 * 6) - 1, y = b.centre(n / 6 * 14) - 1;
        b.add({x, y}, {x + wide[n % 6], y}, {x, y + 12 * b.one()}).swing(n / 6);
      }
      push_frame(frames,
                 fmt::format("extreme: full scale within 1 to 4 pixels: |{}| above 2^(b−2), wrapping steps", along), b);
    }
    {
      // From vertex 0 to a centre an odd number of sub-pixels: the top bit of the gradient decides.
      FrameBuilder b(format, 32, 8, turned);
      for (int n = 0; n < 16; ++n) {
        const int x = b.centre(2 * n) - 1, wide = 1 + n % 4;
        b.add({x, -2 * b.one()}, {x + wide, -2 * b.one()}, {x + 1, 10 * b.one()});
        b.swing(n / 4 % 2 ? 0 : 1, n >= 8);
      }
      push_frame(frames, fmt::format("extreme: full scale within 1 to 4 sub-pixels: |{}| above 2^(b+f−2)", along), b);
    }
    {
      // The same over the guard band, where distances to vertex 0 are largest as well.
      FrameBuilder b(format, 32, 8, turned);
      for (int n = 0; n < 16; ++n) {
        const int x = b.centre(2 * n) - 1, wide = 1 + n % 4;
        b.add({x, b.low()}, {x + wide, b.low()}, {x + 1, b.high()}).swing(n / 4 % 3, n >= 8);
      }
      push_frame(frames, fmt::format("extreme: the same over the guard band: the largest {}, farthest away", along), b);
    }
    {
      // A gradient of an LSB over the guard band: rounding is all there is.
      FrameBuilder b(format, 12, 8, turned);
      b.add({b.low(), b.low()}, {b.high(), b.low()}, {b.centre(6), b.high()});
      const std::uint32_t d = b.full_depth() / 3;
      b.depth(d, d + 1, d);
      for (int v = 0; v < 3; ++v) {
        for (int channel = 0; channel < 3; ++channel) {
          b.back().rgb[v][channel] = std::uint8_t(b.colour(126) + (v == channel));
        }
      }
      push_frame(frames, fmt::format("extreme: an LSB over the guard band: the smallest {}", along), b);
    }
  }
  return frames;
}

std::vector<NamedFrame> equal_depth_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  const std::uint32_t full = ref::full_depth(format.depth_bits);
  for (const std::uint32_t of : {0u, 1u, full / 3, full / 2 + 1, full - 1}) {
    const std::uint32_t d = std::min(of, full);
    FrameBuilder b(format, 24, 12);
    for (int wide = 1; wide <= 3; ++wide) {
      const int at = b.centre(2 * wide);
      b.add({b.low(), at - 1}, {b.high(), at}, {b.low(), at - 1 + wide}).depth(d);
      b.add({at - 1, b.low()}, {at, b.high()}, {at - 1 + wide, b.low()}).depth(d);
      b.add({b.low(), b.low()}, {b.high(), b.high()}, {b.low() + wide, b.low()}).depth(d);
    }
    b.add({b.centre(20), b.centre(3)}, {b.centre(20) + 1, b.centre(3)}, {b.centre(20), b.centre(3) + 1}).depth(d);
    b.add({b.low(), b.low()}, {b.high(), b.low()}, {b.centre(6), b.high()}).depth(d);
    push_frame(frames, fmt::format("extreme: depth {} at all vertices, of slivers and of the largest triangle", d), b);
  }
  return frames;
}

std::vector<NamedFrame> full_scale_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, 24, 16);
    const int one = b.one();
    const std::uint32_t d = b.full_depth() / 3;
    for (const std::uint32_t depth : {d, d, d - 1, d + 1}) b.add({0, 0}, {20 * one, 0}, {0, 15 * one}).depth(depth);
    push_frame(frames, "extreme: equal depths and depths one LSB apart", b);
  }
  {
    FrameBuilder b(format, 24, 16);
    const int one = b.one();
    const std::uint32_t d = b.full_depth();
    b.add({0, 0}, {30 * one, 0}, {0, 30 * one}).depth(d);
    b.add({0, 0}, {30 * one, 0}, {0, 30 * one}).depth(d - 1);
    b.add({0, 0}, {20 * one, 0}, {0, 15 * one}).depth(0);
    b.add({4 * one, 0}, {24 * one, 8 * one}, {4 * one, 16 * one}).depth(0, d, d);
    for (auto& colour : b.back().rgb) colour.fill(b.colour(255));
    push_frame(frames, "extreme: depth 0, 2^b − 2 and full scale, which never passes; colour 0 and full scale", b);
  }
  return frames;
}

}  // namespace halfspace::model
