// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/awkward.hpp"

#include <algorithm>
#include <random>

#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {

LightingFrame awkward_normals(std::size_t triangles, const Config& config, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<LightingFrame> sources = lighting_frames(config, seed);
  LightingFrame frame = std::move(sources[seed % sources.size()]);
  const std::vector<RawNormals> given = std::move(frame.triangles);
  frame.triangles.clear();
  // As many materials as make a difference: the words of a frame are loaded before it.
  frame.materials.resize(std::min<std::size_t>(frame.materials.size(), 16));
  const int limit = 1 << config.normal_bits;
  for (std::size_t k = 0; k < triangles; ++k) {
    RawNormals& out = frame.triangles.emplace_back(given[random() % given.size()]);
    out.index = int(k) + 1;
    out.material %= int(frame.materials.size());
    auto& n = out.normals;
    for (int c = 0; c < 3; ++c) {
      switch (k % 4) {
        case 1: n[1][c] = n[2][c] = std::min(-n[0][c], limit - 1); break;
        case 2:
          for (auto& vertex : n) vertex[c] = random() % 2 ? limit - 1 : -limit;
          break;
        case 3:
          for (int v = 1; v < 3; ++v) n[v][c] = std::clamp(n[0][c] + int(random() % 5) - 2, -limit, limit - 1);
          break;
        default: break;
      }
    }
  }
  return frame;
}

std::vector<NamedFrame> normal_frames(const ref::RasterFormat& format, const Config& config, std::uint64_t seed) {
  constexpr int kCell = 3;  // pixels each way
  const int columns = std::max(std::min(format.width, 96) / kCell, 1),
            rows = std::max(std::min(format.height, 96) / kCell, 1);
  const std::size_t most = std::size_t(std::min(columns * rows, format.triangles));
  std::vector<NamedFrame> frames;
  for (const LightingFrame& all : lighting_frames(config, seed)) {
    for (std::size_t from = 0; from < all.triangles.size(); from += most) {
      LightingFrame part = all;
      part.triangles.assign(all.triangles.begin() + long(from),
                            all.triangles.begin() + long(std::min(from + most, all.triangles.size())));
      FrameBuilder b(format, columns * kCell, rows * kCell);
      const int one = b.one();
      for (std::size_t k = 0; k < part.triangles.size(); ++k) {
        const int x = int(k) % columns * kCell * one, y = int(k) / columns * kCell * one;
        b.add({x, y}, {x + 2 * one, y}, {x, y + 2 * one});
      }
      frames.push_back({all.note, b.list(), std::move(part)});
    }
  }
  return frames;
}

}  // namespace halfspace::model
