// SPDX-License-Identifier: Apache-2.0
// Extremes of coverage. c: bits of a position; S = 2^c − 1: the side of the guard band in sub-pixels.
#include <fmt/format.h>

#include "vectors/frames/extremes.hpp"
#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;

std::vector<NamedFrame> smallest_area_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, 13, 11);
    const int one = b.one();
    b.add({one, one}, {one, one}, {one, one});
    b.add({one, 2 * one}, {9 * one, 2 * one}, {one, 2 * one});
    b.add({b.centre(1), b.centre(1)}, {b.centre(5), b.centre(5)}, {b.centre(9), b.centre(9)});
    b.add({b.centre(1), b.centre(3)}, {b.centre(12), b.centre(3)}, {b.centre(7), b.centre(3)});
    b.add({b.centre(4), b.centre(0)}, {b.centre(4), b.centre(9)}, {b.centre(4), b.centre(2)});
    b.add({b.low(), b.low()}, {b.high(), b.high()}, {b.centre(5), b.centre(5)});
    push_frame(frames,
               "extreme: D = 0: equal, collinear through centres, and across the guard band: 2^(2c−1) − 2^(2c−1)", b);
  }
  {
    FrameBuilder b(format, 10, 9);
    for (int d = 1; d <= 4; ++d) {
      for (int turn = 0; turn < 4; ++turn) {
        const int x = b.centre(2 * d), y = b.centre(2 * turn), right = turn & 1 ? -1 : 1, down = turn & 2 ? -1 : 1;
        b.add({x, y}, {x + d * right, y}, {x, y + down});
      }
    }
    push_frame(frames, "extreme: D = 1, 2, 3, 4 with a vertex on a centre, in four orientations", b);
  }
  {
    FrameBuilder b(format, 18, 8);
    for (int d = 1; d <= 4; ++d) {
      for (int side = -1; side <= 1; side += 2) {
        // (n, n − 1) × (m, m − 1) = n − m = d: vectors all but opposite, from a centre to both ends of the guard band.
        const int x = b.centre(4 * d), flat = b.centre(3 + 2 * side), steep = flat + b.one();
        const int n = b.high() - b.centre(18), m = n - d;
        b.add({x - side * m, flat - (m - 1)}, {x, flat}, {x + side * n, flat + n - 1});
        b.add({x - side * (m - 1), steep - m}, {x, steep}, {x + side * (n - 1), steep + n});
      }
    }
    push_frame(frames, "extreme: D = 1, 2, 3, 4 across the guard band, a vertex on a centre: the largest aspect ratio",
               b);
  }
  return frames;
}

std::vector<NamedFrame> centre_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, 16, 16);
    const Point hub{b.centre(7), b.centre(7)};
    const Point rim[8] = {{1, 1}, {7, 1}, {13, 1}, {13, 7}, {13, 13}, {7, 13}, {1, 13}, {1, 7}};
    for (int n = 0; n < 8; ++n) {
      const Point from = rim[n], to = rim[(n + 1) % 8];
      b.add(hub, {b.centre(from.x), b.centre(from.y)}, {b.centre(to.x), b.centre(to.y)});
    }
    push_frame(frames, "extreme: eight triangles around a vertex on a centre, all vertices on centres: one covers it",
               b);
  }
  {
    FrameBuilder b(format, 26, 26);
    const Point slopes[4] = {{11, 11}, {10, 5}, {4, 12}, {9, 3}};
    for (int n = 0; n < 4; ++n) {
      const int left = n % 2 * 13, top = n / 2 * 13;
      const int right = left + slopes[n].x, bottom = top + slopes[n].y;
      const bool falls = n < 2;
      const Point from{b.centre(left), b.centre(falls ? top : bottom)};
      const Point to{b.centre(right), b.centre(falls ? bottom : top)};
      b.add(from, to, {from.x, to.y});
      b.add(to, from, {to.x, from.y});
    }
    push_frame(frames, "extreme: edges through many centres, with a triangle on both sides", b);
  }
  {
    FrameBuilder b(format, 32, 8);
    const int inset[4] = {0, b.half(), b.half() - 1, b.half() + 1};  // border, centre, beside the centre
    for (int n = 0; n < 4; ++n) {
      const int x0 = 8 * n * b.one() + inset[n], y0 = inset[n], x1 = x0 + 6 * b.one(), y1 = y0 + 6 * b.one();
      b.add({x0, y0}, {x1, y0}, {x0, y1});
      b.add({x1, y1}, {x0, y1}, {x1, y0});
    }
    push_frame(frames, "extreme: rectangles with edges on borders and centres of pixels, and one sub-pixel beside", b);
  }
  return frames;
}

std::vector<NamedFrame> box_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  for (const bool turned : {false, true}) {
    FrameBuilder b(format, 140, 8, turned);
    for (int size = 127; size <= 129; ++size) {
      b.add({b.half(), b.half()}, {b.centre(size), b.half()}, {b.half(), 7 * b.one()});
      b.add({size * b.one(), 0}, {size * b.one(), b.centre(7)}, {0, b.centre(7)});
    }
    push_frame(frames, fmt::format("extreme: boxes {} 127 to 129 pixels", turned ? "as high as" : "as wide as"), b);
  }
  return frames;
}

std::vector<NamedFrame> sliver_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  for (const bool turned : {false, true}) {
    for (const bool band : {false, true}) {
      const int length = band ? 32 : turned ? format.height : format.width;
      FrameBuilder b(format, length, 8, turned);
      const int left = band ? b.low() : 0, right = band ? b.high() : length * b.one();
      for (int row = 0; row < 8; ++row) {
        const int y = b.centre(row), wide = 1 + row % 4 % 3;  // 1, 2, 3 and 1 sub-pixels
        const int from = row % 2 ? right : left, to = row % 2 ? left : right;
        const int above = row % 4 == 0 ? 0 : 1;  // of width 1: first with all centres on its upper edge, then its lower
        b.add({from, y - above}, {to, y - above + wide / 2}, {from, y - above + wide});
        b.swing(row % 3, row >= 4);
      }
      push_frame(frames,
                 fmt::format("extreme: slivers 1 to 3 sub-pixels {} across the {}", turned ? "wide" : "high",
                             band ? "guard band" : "largest frame"),
                 b);
    }
    // Between corners of the guard band and on x = y, the diagonal through centres.
    FrameBuilder b(format, 40, 40, turned);
    for (int wide = 1; wide <= 3; ++wide) {
      b.add({b.low(), b.low()}, {b.high(), b.high()}, {b.low() + wide, b.low()});
      b.add({b.low(), b.high()}, {b.high(), b.low() + 50 * wide * b.one()}, {b.low() + wide, b.high()});
      b.add({b.low(), b.low() + 1}, {b.high() - wide, b.high()}, {b.high() - 1, b.high()});
    }
    push_frame(frames, fmt::format("extreme: slivers between corners of the guard band{}", turned ? ", turned" : ""),
               b);
    FrameBuilder needles(format, 32, 32, turned);
    for (int i = 0; i < 8; ++i) {
      const int y = 3 * needles.one() * i + needles.half();
      needles.add({needles.one(), y - 1}, {31 * needles.one(), y + i}, {16 * needles.one(), y + 1});
    }
    push_frame(frames, fmt::format("extreme: needles{}", turned ? ", standing" : ""), needles);
  }
  return frames;
}

std::vector<NamedFrame> guard_band_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, 12, 8);
    const Point corners[4] = {{b.low(), b.low()}, {b.high(), b.low()}, {b.high(), b.high()}, {b.low(), b.high()}};
    for (int n = 0; n < 4; ++n) {
      const Point &p = corners[n], &q = corners[(n + 1) % 4], &r = corners[(n + 2) % 4];
      b.add(p, q, r).swing(n % 3);
      b.add(q, p, r).swing(n % 3, true);
    }
    // Nothing covered, and the largest edge function of the edge that vertex 0 is not on.
    b.add({b.high(), b.low()}, {b.low(), b.high()}, {b.low(), b.low() + 1});
    push_frame(frames, "extreme: corners of the guard band, three of the four: positions −2^(c−1) and 2^(c−1) − 1", b);
  }
  // A whole side and a point of the opposite one: every number of the setup has its top bit. One triangle a frame: each
  // covers all of it.
  constexpr const char* kSides[4] = {"upper", "lower", "left", "right"};
  for (int side = 0; side < 4; ++side) {
    for (int vertex = 0; vertex < 3; ++vertex) {
      for (const bool inverse : {false, true}) {
        FrameBuilder b(format, 12, 8, side >= 2);
        const int from = side % 2 ? b.high() : b.low(), to = side % 2 ? b.low() : b.high();
        b.add({b.low(), from}, {b.high(), from}, {b.centre(6), to}).swing(vertex, inverse);
        push_frame(frames,
                   fmt::format("extreme: the {} side of the guard band: |dx| = S, D = S², s = 2c − 1, E > 2^(2c−1), "
                               "|N| = (2^b − 1)·S",
                               kSides[side]),
                   b);
      }
    }
  }
  return frames;
}

std::vector<NamedFrame> order_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  auto add = [&](FrameBuilder& b, const Point(&points)[3], const int(&order)[3]) {
    b.add(points[order[0]], points[order[1]], points[order[2]]);
    for (int v = 0; v < 3; ++v) {
      b.back().depth[v] = b.full_depth() / std::uint32_t(2 + order[v]);
      b.back().rgb[v] = {b.colour(80 * order[v]), b.colour(255 - 80 * order[v]), b.colour(17)};
    }
  };
  FrameBuilder b(format, 16, 16), tops(format, 20, 30), band(format, 16, 16);
  const int one = b.one();
  const Point any[3] = {{one + 3, 2 * one + 7}, {14 * one - 5, 5 * one}, {6 * one + 1, 13 * one + 3}};
  const Point far[3] = {{b.low(), b.centre(3)}, {b.high(), b.centre(9)}, {b.centre(9), b.low()}};
  for (int n = 0; n < 6; ++n) {
    add(b, any, kOrders[n]);
    add(band, far, kOrders[n]);
    const int down = 5 * one * n;
    const int top = b.centre(1) + down;
    const Point flat[3] = {{2 * one + 1, top}, {17 * one + 3, top}, {9 * one, 5 * one + down}};
    add(tops, flat, kOrders[n]);
  }
  push_frame(frames, "extreme: six orders of the same vertices: the first wins every pixel", b);
  push_frame(frames, "extreme: six orders of vertices at the ends of the guard band: the first wins every pixel", band);
  push_frame(frames, "extreme: flat tops, in all six orders of the vertices", tops);
  return frames;
}

}  // namespace halfspace::model
