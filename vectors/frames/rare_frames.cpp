// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/rare_frames.hpp"

#include <fmt/format.h>

#include "model/texture/texture.hpp"
#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {
namespace {

// Only the centre of this pixel lies inside.
void add_pixel(FrameBuilder& b, int x, int y, std::uint32_t depth) {
  const int one = b.one();
  b.add({x * one, y * one}, {(x + 1) * one, y * one}, {x * one, (y + 1) * one + 1}).depth(depth);
}

// One stamp, of as many lanes as there may be, by frames that follow each other: what the frame before writes there in
// the other bank is nearer, or farther, in the same lane or in others.
void add_one_stamp(const ref::RasterFormat& format, std::vector<NamedFrame>& frames) {
  for (int n = 0; n < 48; ++n) {
    FrameBuilder b(format, 8, 8);
    const std::uint32_t step = b.full_depth() / 8;
    const bool disjoint = n % 2 == 1;
    for (int i = 0; i <= n % 3; ++i) {
      const int lane = disjoint ? (n + i) % 2 : 0;
      add_pixel(b, lane, lane, step * std::uint32_t(1 + (3 * n + i) % 7));
    }
    push_frame(frames,
               fmt::format("rare: a stamp after that of the frame before, {} lanes", disjoint ? "other" : "the same"),
               b);
  }
}

// The planes of one kind are stored long before those of the other: without a texture there is nothing to set up, and
// scan-out reads both of the first pixel at once.
void add_textures_that_end_early(const ref::RasterFormat& format, const Config& config,
                                 std::vector<NamedFrame>& frames) {
  for (int n = 0; n < 12; ++n) {
    FrameBuilder b(format, 3, 3);
    const int triangles = 1 + n % 3;
    NamedFrame frame;
    frame.note = "rare: texture planes that end before the colour planes, or behind them";
    frame.texture.textures.push_back({0, 1, 1});
    for (int k = 0; k < 4; ++k) {
      RawTexel& texel = frame.texture.texels.emplace_back();
      texel.address = k;
      texel.rgb.fill(std::uint8_t((1 << config.colour_bits) - 1 - k));
    }
    for (int k = 0; k < triangles; ++k) {
      b.add({0, 0}, {4 * b.one(), 0}, {0, 4 * b.one()}).depth(b.full_depth() / 2 - std::uint32_t(k));
      for (auto& rgb : b.back().rgb) rgb.fill(b.colour((37 * n + 91 * k + 16) % 256));
      RawCoordinates& at = frame.texture.triangles.emplace_back();
      const int full = (1 << config.coordinate_bits) - 1;
      at.s = {0, full / 2, 0}, at.t = {0, 0, full / 2};
      if (has_perspective(config)) at.q.fill(full);
      at.texture = k + 1 == triangles && n % 4 != 3 ? 0 : 1;
    }
    frame.scene = b.list();
    frames.push_back(std::move(frame));
  }
}

}  // namespace

std::vector<NamedFrame> rare_frames(const ref::RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  add_one_stamp(format, frames);
  if (has_texture(config)) add_textures_that_end_early(format, config, frames);
  if (!shades(config)) {
    for (NamedFrame& frame : far_ways(format, config)) frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace halfspace::model
