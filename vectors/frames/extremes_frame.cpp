// SPDX-License-Identifier: Apache-2.0
// Extremes of the snap, of sizes and of numbers of triangles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "vectors/frames/extremes.hpp"
#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;

ref::TriangleList finer_than_the_grid(const RasterFormat& format) {
  ref::TriangleList list{std::min(36, format.width), std::min(24, format.height), {16, 24, 40}, {}};
  const double step = std::ldexp(1, -format.subpixel_bits - 1);  // half a sub-pixel
  const double hair = std::ldexp(1, -format.subpixel_bits - 20);
  for (int n = 0; n < 9; ++n) {
    const int steps = n / 3 - 1, hairs = n % 3 - 1;
    const double beside = steps * step + hairs * hair;
    for (int row = 0; row < 4; ++row) {
      // Two with vertices near centres, two near the first grid line beside one, where a tie goes away from the centre.
      const double x = 4 * n + 0.5 + beside + (row % 2) * 2 * step, y = 6 * row + 0.5 + beside + (row % 2) * 2 * step;
      const double size = row < 2 ? 3 : -3, x0 = row < 2 ? x : x + 3, y0 = row < 2 ? y : y + 4;
      if (std::max({x0, y0, x0 + size, y0 + size}) + 1 > std::ldexp(1, format.range_bits - 1)) continue;
      list.triangles.push_back(
          {{{x0, y0, 0.25, 255, 0, 9}, {x0 + size, y0, 0.5, 0, 255, 9}, {x0, y0 + size, 0.75, 0, 0, 9}}});
    }
  }
  return list;
}

std::vector<NamedFrame> snapped_frames(const RasterFormat& format) {
  RasterFormat roomy = format;
  roomy.triangles = 1 << 20;
  ref::SnappedList list = ref::snap(finer_than_the_grid(format), roomy);
  list.format = format;
  std::vector<NamedFrame> frames;
  push_frame(frames, "extreme: positions finer than the grid, ties to even among them", std::move(list));
  return frames;
}

std::vector<NamedFrame> frame_size_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, 1, 1);
    b.add({0, 0}, {2 * b.one(), 0}, {0, 2 * b.one()});
    push_frame(frames, "extreme: frame of 1x1", b);
  }
  for (const bool turned : {false, true}) {
    const int length = turned ? format.height : format.width;
    FrameBuilder b(format, length, 1, turned);
    const int last = b.centre(length - 1);
    const std::uint32_t full = b.full_depth();
    b.add({b.low(), b.low()}, {b.low(), b.high()}, {b.high(), 0}).depth(full / 4 * 3, full / 4 * 3, full - 1);
    b.add({b.high(), b.low()}, {b.high(), b.high()}, {b.low(), 0}).depth(full / 2, full / 2, full / 8);
    b.add({last - 1, 0}, {last + 2, 0}, {last, b.one()}).depth(0, 1, 2);
    b.add({0, 0}, {b.one(), 0}, {0, b.one()}).depth(2, 1, 0);
    push_frame(frames,
               fmt::format("extreme: frame of the largest {0} and one pixel: {1} = {2} − 1, the longest walk",
                           turned ? "height" : "width", turned ? "y" : "x", length),
               b);
  }
  return frames;
}

std::vector<NamedFrame> largest_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, format.width, format.height);
    const int right = format.width * b.one(), bottom = format.height * b.one();
    b.add({b.low(), b.low()}, {b.high(), b.low()}, {b.centre(format.width / 2), b.high()});
    b.add({0, 0}, {right, bottom}, {0, 2}).depth(0, 1, 2);
    b.add({right, 0}, {0, bottom}, {right, 2}).depth(0, 1, 2);
    b.add({right - b.one(), bottom - b.one()}, {right, bottom - b.one()}, {right, bottom}).depth(0);
    b.add({0, bottom - b.one()}, {b.one(), bottom - b.one()}, {0, bottom}).depth(0);
    push_frame(frames, "extreme: the largest frame, its corners and diagonals", b);
  }
  {
    FrameBuilder b(format, 16, 8);
    for (int k = 2; k < format.triangles; ++k) b.add({b.one(), b.one()}, {b.one(), b.one()}, {b.one(), b.one()});
    if (format.triangles > 1) b.add({0, 0}, {16 * b.one(), 0}, {0, 8 * b.one()});
    b.add({16 * b.one(), 0}, {16 * b.one(), 8 * b.one()}, {0, 8 * b.one()});
    push_frame(frames, fmt::format("extreme: index {}, the last one", format.triangles), b);
  }
  return frames;
}

}  // namespace halfspace::model
