// SPDX-License-Identifier: Apache-2.0
#include "vectors/standard_set.hpp"

#include <fmt/format.h>

#include <iterator>
#include <random>

#include "vectors/frames/awkward.hpp"
#include "vectors/frames/extremes.hpp"
#include "vectors/frames/frame_builder.hpp"
#include "vectors/frames/index_frames.hpp"

namespace halfspace::model {

using ref::RasterFormat;

namespace {

// What units do with streams and buffers, whatever the numbers.
std::vector<NamedFrame> flow_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames;
  {
    FrameBuilder b(format, 9, 7);
    push_frame(frames, "corner: no triangle at all, index 0: the background alone", b);
  }
  {
    FrameBuilder b(format, 5, 3);
    const int one = b.one();
    b.add({-one, -one}, {8 * one, -one}, {-one, 8 * one});
    b.add({2 * one, 2 * one}, {40 * one, 2 * one}, {3 * one, 40 * one});
    push_frame(frames, "corner: frame that is no multiple of a stamp, triangles over its right and lower border", b);
  }
  {
    FrameBuilder b(format, 40, 30);
    const int one = b.one();
    const std::uint32_t full = b.full_depth();
    for (std::uint32_t i = 0; i < 24; ++i) {
      b.add({8 * one, 8 * one}, {12 * one, 8 * one}, {8 * one, 12 * one}).depth(full - 1 - i, full - 1 - i, full / 5);
    }
    push_frame(frames, "corner: the same stamps again and again, nearer each time", b);
  }
  // One stamp over and over, frames of one to six triangles that follow at once: reads that meet writes on their way,
  // of this frame and of the one before.
  for (int n = 0; n < 24; ++n) {
    FrameBuilder b(format, 8, 8);
    const int one = b.one();
    for (int i = 0; i <= n % 6; ++i) {
      const std::uint32_t d = b.full_depth() / 8 * std::uint32_t(1 + (5 * i + n) % 7);
      b.add({one, one}, {3 * one, one}, {one, 3 * one}).depth(d, d + 1, d);
    }
    push_frame(frames, "corner: tiny frames on one spot", b);
  }
  return frames;
}

}  // namespace

std::vector<NamedFrame> corner_frames(const RasterFormat& format) {
  std::vector<NamedFrame> frames = flow_frames(format);
  for (NamedFrame& frame : extreme_frames(format)) frames.push_back(std::move(frame));
  return frames;
}

std::vector<NamedFrame> random_frames(const RasterFormat& format, std::uint64_t seed, int count, int triangles) {
  std::vector<NamedFrame> frames;
  std::mt19937_64 random(seed);
  auto below = [&](std::uint64_t n) { return random() % n; };
  for (int f = 0; f < count; ++f) {
    const int width = 1 + int(below(std::uint64_t(std::min(format.width, 200))));
    const int height = 1 + int(below(std::uint64_t(std::min(format.height, 120))));
    FrameBuilder b(format, width, height);
    auto any_colour = [&] { return b.colour(int(below(256))); };
    for (auto& channel : b.list().background) channel = any_colour();
    const int one = b.one();
    for (int n = 0; n < std::min(triangles, format.triangles); ++n) {
      // Small ones, middling ones, ones that reach over the frame, slivers.
      const int kind = int(below(4));
      const int spread = kind == 0 ? 6 * one : kind == 1 ? 30 * one : 400 * one;
      const int cx = int(below(std::uint64_t(width) * one)), cy = int(below(std::uint64_t(height) * one));
      Point points[3];
      for (Point& p : points) {
        p.x = cx + int(below(std::uint64_t(spread))) - spread / 2;
        p.y = cy + int(below(std::uint64_t(spread))) - spread / 2;
      }
      if (kind == 3) {
        points[1].x = points[0].x + int(below(7)) - 3;
        points[1].y = points[0].y + int(below(7)) - 3;
      }
      b.add(points[0], points[1], points[2]);
      for (auto& depth : b.back().depth) depth = std::uint32_t(below(b.full_depth() + std::uint64_t(1)));
      for (auto& rgb : b.back().rgb) {
        for (auto& channel : rgb) channel = any_colour();
      }
    }
    push_frame(frames, fmt::format("random: {} triangles, seed {}, frame {}", triangles, seed, f), b);
  }
  return frames;
}

namespace {

void add_normals(const Config& config, std::uint64_t seed, std::vector<NamedFrame>& frames) {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    if (!frames[n].lighting.triangles.empty()) continue;  // the scene's
    frames[n].lighting = awkward_normals(frames[n].scene.triangles.size(), config, seed + n);
  }
}

void add_coordinates_and_motion(const Config& config, std::uint64_t seed, std::vector<NamedFrame>& frames) {
  for (std::size_t n = 0; n < frames.size(); ++n) {
    NamedFrame& frame = frames[n];
    if (has_texture(config) && frame.texture.triangles.empty()) {
      frame.texture = awkward_coordinates(frame.scene.triangles.size(), config, seed + n);
    }
    if (has_motion(config) && frame.motion.triangles.empty()) {
      frame.motion = awkward_motion(frame.scene, config, seed + n);
    }
  }
}

void put_before(std::vector<NamedFrame>& frames, std::vector<NamedFrame> first) {
  frames.insert(frames.begin(), std::make_move_iterator(first.begin()), std::make_move_iterator(first.end()));
}

}  // namespace

void add_awkward(const Configuration& configuration, std::uint64_t seed, std::vector<NamedFrame>& frames) {
  const Config config = configuration.config();
  if (has_lighting(config)) add_normals(config, seed, frames);
  add_coordinates_and_motion(config, seed, frames);
}

std::vector<NamedFrame> standard_frames(const Configuration& configuration, std::uint64_t seed, int random,
                                        int triangles, std::vector<NamedFrame> frames) {
  const Config config = configuration.config();
  const RasterFormat format = raster_format(configuration);
  if (gives_indices(config)) put_before(frames, index_frames(format, config));
  put_before(frames, random_frames(format, seed, random, triangles));
  put_before(frames, corner_frames(format));
  // Frames for the normals have theirs.
  if (has_lighting(config)) {
    add_normals(config, seed, frames);
    put_before(frames, normal_frames(format, config, seed));
  }
  add_coordinates_and_motion(config, seed, frames);
  return frames;
}

}  // namespace halfspace::model
