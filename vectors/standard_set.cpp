// SPDX-License-Identifier: Apache-2.0
#include "vectors/standard_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace halfspace::vectors {
namespace {

using ref::RasterFormat;
using ref::SnappedList;
using ref::SnappedTriangle;

// Builds frames in pixels and sub-pixels of one format.
class FrameBuilder {
 public:
  FrameBuilder(const RasterFormat& format, int width, int height, std::array<std::uint8_t, 3> background = {16, 24, 40})
      : list_{format, width, height, background, {}}, one_(1 << format.subpixel_bits) {}

  int one() const { return one_; }
  std::uint32_t full_depth() const { return std::uint32_t((std::uint64_t(1) << list_.format.depth_bits) - 1); }
  int limit() const { return 1 << (list_.format.range_bits - 1 + list_.format.subpixel_bits); }

  // Positions in sub-pixels; depths at the vertices.
  FrameBuilder& add(std::array<int, 3> x, std::array<int, 3> y, std::array<std::uint32_t, 3> depth) {
    SnappedTriangle t{};
    for (int v = 0; v < 3; ++v) {
      t.x[v] = std::clamp(x[v], -limit(), limit() - 1);
      t.y[v] = std::clamp(y[v], -limit(), limit() - 1);
      t.depth[v] = depth[v];
      for (int c = 0; c < 3; ++c) t.rgb[v][c] = std::uint8_t(c == v ? 255 : 0);
    }
    list_.triangles.push_back(t);
    return *this;
  }
  FrameBuilder& add(std::array<int, 3> x, std::array<int, 3> y) {
    const std::uint32_t d = full_depth();
    return add(x, y, {d / 2, d / 4, d / 4 * 3});
  }
  SnappedTriangle& back() { return list_.triangles.back(); }
  SnappedList done() { return list_; }

 private:
  SnappedList list_;
  int one_;
};

}  // namespace

std::vector<NamedFrame> corner_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  const int one = 1 << format.subpixel_bits, half = one / 2;
  auto builder = [&](int width, int height) { return FrameBuilder(format, width, height); };
  auto push = [&](const char* note, FrameBuilder& b) { frames.push_back({note, b.done()}); };

  {
    auto b = builder(9, 7);
    push("corner: no triangle at all, the background alone", b);
  }
  {
    auto b = builder(13, 11);
    b.add({one, one, one}, {one, one, one});
    b.add({one, 5 * one, 9 * one}, {one, 5 * one, 9 * one});
    b.add({one, 9 * one, one}, {2 * one, 2 * one, 2 * one});
    push("corner: D = 0: three equal vertices, collinear, two equal", b);
  }
  {
    auto b = builder(13, 11);
    for (int d = 1; d <= 4; ++d) {
      b.add({3 * one + half, 3 * one + half + d, 3 * one + half}, {3 * one + half, 3 * one + half, 3 * one + half + 1});
    }
    push("corner: D = 1, 2, 3, 4 around a pixel centre", b);
  }
  {
    auto b = builder(16, 16);
    b.add({2 * one + half, 12 * one + half, 2 * one + half}, {2 * one + half, 2 * one + half, 12 * one + half});
    b.add({12 * one + half, 12 * one + half, 2 * one + half}, {2 * one + half, 12 * one + half, 12 * one + half});
    push("corner: two triangles share a diagonal through pixel centres, all vertices on centres", b);
  }
  {
    auto b = builder(16, 16);
    const std::array<int, 3> x = {one + 3, 14 * one - 5, 6 * one + 1}, y = {2 * one + 7, 5 * one, 13 * one + 3};
    const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (const auto& o : order) {
      b.add({x[o[0]], x[o[1]], x[o[2]]}, {y[o[0]], y[o[1]], y[o[2]]});
      for (int v = 0; v < 3; ++v) {
        b.back().depth[v] = b.full_depth() / (2 + o[v]);
        b.back().rgb[v] = {std::uint8_t(80 * o[v]), std::uint8_t(255 - 80 * o[v]), 17};
      }
    }
    push("corner: six orders of the same vertices: the first wins every pixel", b);
  }
  {
    auto b = builder(20, 30);
    const std::array<int, 3> x = {2 * one + 1, 17 * one + 3, 9 * one}, y = {one + half, one + half, 5 * one};
    const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int n = 0; n < 6; ++n) {
      const auto& o = order[n];
      const int down = 5 * one * n;
      b.add({x[o[0]], x[o[1]], x[o[2]]}, {y[o[0]] + down, y[o[1]] + down, y[o[2]] + down});
    }
    push("corner: flat tops, in all six orders of the vertices", b);
  }
  {
    auto b = builder(24, 16);
    const std::uint32_t d = b.full_depth() / 3;
    b.add({0, 20 * one, 0}, {0, 0, 15 * one}, {d, d, d});
    b.add({0, 20 * one, 0}, {0, 0, 15 * one}, {d, d, d});
    b.add({0, 20 * one, 0}, {0, 0, 15 * one}, {d - 1, d - 1, d - 1});
    b.add({0, 20 * one, 0}, {0, 0, 15 * one}, {d + 1, d + 1, d + 1});
    push("corner: equal depths and depths one LSB apart", b);
  }
  {
    auto b = builder(24, 16);
    const std::uint32_t d = b.full_depth();
    b.add({0, 30 * one, 0}, {0, 0, 30 * one}, {d, d, d});
    b.add({0, 20 * one, 0}, {0, 0, 15 * one}, {0, 0, 0});
    b.add({4 * one, 24 * one, 4 * one}, {0, 8 * one, 16 * one}, {0, d, d});
    for (int v = 0; v < 3; ++v) b.back().rgb[v] = {255, 255, 255};
    push("corner: depth 0 and full scale (which never passes), colour at full scale", b);
  }
  {
    auto b = builder(1, 1);
    b.add({0, 2 * one, 0}, {0, 0, 2 * one});
    push("corner: frame of 1x1", b);
  }
  {
    auto b = builder(5, 3);
    b.add({-one, 8 * one, -one}, {-one, -one, 8 * one});
    b.add({2 * one, 40 * one, 3 * one}, {2 * one, 2 * one, 40 * one});
    push("corner: frame that is no multiple of a stamp, triangles over its right and lower border", b);
  }
  {
    const int w = std::min(format.width, 160), h = std::min(format.height, 100);
    auto b = builder(w, h);
    const int limit = b.limit();
    b.add({-limit, limit - 1, -limit}, {-limit, -limit, limit - 1});
    b.add({limit - 1, limit - 1, -limit}, {-limit, limit - 1, limit - 1});
    b.add({-limit, limit - 1, w * half}, {h * half, h * half + 1, h * half + 2});
    b.add({w * half, w * half + 1, w * half + 2}, {-limit, limit - 1, h * half});
    push("corner: the ends of the guard band, and slivers across the frame", b);
  }
  {
    auto b = builder(140, 8);
    for (int size = 127; size <= 129; ++size) {
      b.add({half, size * one + half, half}, {half, half, 7 * one});
      b.add({size * one, size * one, 0}, {0, 7 * one + half, 7 * one + half});
    }
    push("corner: bounding boxes of 127 to 129 pixels", b);
  }
  {
    auto b = builder(40, 30);
    for (int i = 0; i < 24; ++i) {
      b.add({8 * one, 12 * one, 8 * one}, {8 * one, 8 * one, 12 * one},
            {b.full_depth() - 1 - std::uint32_t(i), b.full_depth() - 1 - std::uint32_t(i), 1000});
    }
    push("corner: the same stamps again and again, nearer each time", b);
  }
  {
    auto b = builder(32, 32);
    // Lying and standing needles, a fraction of a pixel thick, between and on centres.
    for (int i = 0; i < 8; ++i) {
      b.add({one, 31 * one, 16 * one}, {3 * one * i + half - 1, 3 * one * i + half + i, 3 * one * i + half + 1});
      b.add({3 * one * i + half - 1, 3 * one * i + half + i, 3 * one * i + half + 1}, {one, 31 * one, 16 * one});
    }
    push("corner: needles", b);
  }
  // One stamp over and over, frames of one to six triangles that follow at once: reads that meet writes on their way,
  // of this frame and of the one before.
  for (int n = 0; n < 24; ++n) {
    auto b = builder(8, 8);
    for (int i = 0; i <= n % 6; ++i) {
      const std::uint32_t d = b.full_depth() / 8 * std::uint32_t(1 + (5 * i + n) % 7);
      b.add({one, 3 * one, one}, {one, one, 3 * one}, {d, d + 1, d});
    }
    push("corner: tiny frames on one spot", b);
  }
  return frames;
}

std::vector<NamedFrame> random_frames(const RasterFormat& format, std::uint64_t seed, int count, int triangles) {
  std::vector<NamedFrame> frames;
  std::mt19937_64 random(seed);
  auto below = [&](std::uint64_t n) { return random() % n; };
  for (int f = 0; f < count; ++f) {
    const int width = 1 + int(below(std::uint64_t(std::min(format.width, 200))));
    const int height = 1 + int(below(std::uint64_t(std::min(format.height, 120))));
    FrameBuilder b(format, width, height, {std::uint8_t(below(256)), std::uint8_t(below(256)), std::uint8_t(below(256))});
    const int one = b.one();
    for (int n = 0; n < std::min(triangles, format.triangles); ++n) {
      // Small ones, middling ones, ones that reach over the frame, slivers.
      const int kind = int(below(4));
      const int spread = kind == 0 ? 6 * one : kind == 1 ? 30 * one : 400 * one;
      const int cx = int(below(std::uint64_t(width) * one)), cy = int(below(std::uint64_t(height) * one));
      std::array<int, 3> x{}, y{};
      for (int v = 0; v < 3; ++v) {
        x[v] = cx + int(below(std::uint64_t(spread))) - spread / 2;
        y[v] = cy + int(below(std::uint64_t(spread))) - spread / 2;
      }
      if (kind == 3) x[1] = x[0] + int(below(7)) - 3, y[1] = y[0] + int(below(7)) - 3;
      b.add(x, y, {std::uint32_t(below(b.full_depth() + 1ull)), std::uint32_t(below(b.full_depth() + 1ull)),
                   std::uint32_t(below(b.full_depth() + 1ull))});
      for (int v = 0; v < 3; ++v) {
        for (int c = 0; c < 3; ++c) b.back().rgb[v][c] = std::uint8_t(below(256));
      }
    }
    frames.push_back({fmt::format("random: {} triangles, seed {}, frame {}", triangles, seed, f), b.done()});
  }
  return frames;
}

}  // namespace halfspace::vectors
