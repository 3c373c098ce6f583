// SPDX-License-Identifier: Apache-2.0
// Builds frames in sub-pixels of any format.
#ifndef HALFSPACE_VECTORS_FRAMES_FRAME_BUILDER_HPP_
#define HALFSPACE_VECTORS_FRAMES_FRAME_BUILDER_HPP_

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "model/pipeline/named_frame.hpp"

namespace halfspace::model {

struct Point {
  int x, y;  // sub-pixels
};

class FrameBuilder {
 public:
  // A frame is no larger than the format takes. `turned`: x and y change places, in the size and in all that is added.
  FrameBuilder(const ref::RasterFormat& format, int width, int height, bool turned = false)
      : list_{format, turned ? height : width, turned ? width : height, {}, {}}, turned_(turned) {
    list_.width = std::min(list_.width, format.width);
    list_.height = std::min(list_.height, format.height);
    list_.background = {colour(16), colour(24), colour(40)};
  }

  int one() const { return 1 << list_.format.subpixel_bits; }
  int half() const { return one() / 2; }
  int centre(int pixel) const { return pixel * one() + half(); }
  // The ends of the guard band.
  int low() const { return -(1 << (list_.format.range_bits - 1 + list_.format.subpixel_bits)); }
  int high() const { return -low() - 1; }
  std::uint32_t full_depth() const { return ref::full_depth(list_.format.depth_bits); }
  // 0 … 255 as a channel of the format.
  std::uint8_t colour(int of_255) const { return std::uint8_t(of_255 >> (8 - list_.format.colour_bits)); }
  ref::SnappedTriangle& back() { return list_.triangles.back(); }
  ref::SnappedList& list() { return list_; }

  // Beyond the guard band a position moves to its end. Full red, green and blue at a vertex each; depths ½, ¼, ¾.
  FrameBuilder& add(Point a, Point b, Point c) {
    ref::SnappedTriangle t{};
    const Point points[3] = {a, b, c};
    const std::uint32_t d = full_depth();
    t.depth = {d / 2, d / 4, d / 4 * 3};
    for (int v = 0; v < 3; ++v) {
      t.x[v] = std::clamp(turned_ ? points[v].y : points[v].x, low(), high());
      t.y[v] = std::clamp(turned_ ? points[v].x : points[v].y, low(), high());
      t.rgb[v][v] = colour(255);
    }
    list_.triangles.push_back(t);
    return *this;
  }

  // Of the triangle added last, full scale at most:
  FrameBuilder& depth(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const std::uint32_t full = full_depth();
    back().depth = {std::min(a, full), std::min(b, full), std::min(c, full)};
    return *this;
  }
  FrameBuilder& depth(std::uint32_t everywhere) { return depth(everywhere, everywhere, everywhere); }
  // Depth at full scale at one vertex and 0 at the others; if `inverse`, the other way around, colours too.
  FrameBuilder& swing(int vertex, bool inverse = false) {
    for (int v = 0; v < 3; ++v) {
      back().depth[v] = (v == vertex) != inverse ? full_depth() : 0;
      if (!inverse) continue;
      for (auto& channel : back().rgb[v]) channel = std::uint8_t(colour(255) - channel);
    }
    return *this;
  }

 private:
  ref::SnappedList list_;
  bool turned_;
};

// Adds the frame, as several if a frame of the format does not take so many triangles.
inline void push_frame(std::vector<NamedFrame>& frames, const std::string& note, ref::SnappedList list) {
  const std::vector<ref::SnappedTriangle> all = std::move(list.triangles);
  const std::size_t most = std::size_t(list.format.triangles);
  for (std::size_t from = 0; from == 0 || from < all.size(); from += most) {
    list.triangles.assign(all.begin() + from, all.begin() + std::min(from + most, all.size()));
    frames.push_back({note, list});
  }
}
inline void push_frame(std::vector<NamedFrame>& frames, const std::string& note, FrameBuilder& builder) {
  push_frame(frames, note, builder.list());
}

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_FRAME_BUILDER_HPP_
