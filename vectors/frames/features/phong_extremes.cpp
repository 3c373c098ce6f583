// SPDX-License-Identifier: Apache-2.0
// Extremes of normals that vary over a triangle. p: fraction bits of a component; A, B: gradients of a plane.
#include "vectors/frames/extremes.hpp"
#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/features/light_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;
using Normal = LightBuilder::Normal;

std::vector<NamedFrame> opposite_normal_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const LightBuilder light(config);
  NamedFrame with;
  with.lighting.lights = light.axes();
  with.lighting.materials = {light.colourful(0)};
  if (config.materials > 1) with.lighting.materials.push_back(light.colourful(light.squarings()));
  const int m = light.most();
  const Normal ways[7] = {{m, 0, 0}, {0, m, 0}, {0, 0, m}, {m, m, 0}, {0, m, m}, {m, m, m}, {1, 0, 0}};
  // Seven pixels: the middle of a side is a centre, where the normals cancel to nothing.
  push_cells(frames, "extreme: opposite normals at the vertices, which cancel at a pixel's centre", format, 28, 7, with,
             [&](NamedFrame& frame, int k, Point) {
               const Normal n = ways[k % 7], o{-n[0], -n[1], -n[2]};
               const Normal third = k / 7 == 0 ? Normal{0, 0, 0} : k / 7 == 1 ? n : k / 7 == 2 ? o : Normal{1, -1, 0};
               add_normals(frame.lighting, k % int(with.lighting.materials.size()), n, o, third);
             });
  return frames;
}

std::vector<NamedFrame> normal_plane_extremes(const RasterFormat& format, const Config& config) {
  const LightBuilder light(config);
  std::vector<NamedFrame> frames = gradient_frames(format);
  for (NamedFrame& frame : guard_band_frames(format)) frames.push_back(std::move(frame));
  for (NamedFrame& frame : frames) {
    frame.note += "; components of normals from −2^p to 2^p − 1";
    frame.lighting.lights = light.axes();
    frame.lighting.materials = {light.colourful(0)};
    for (std::size_t k = 0; k < frame.scene.triangles.size(); ++k) {
      // A component is at the other end at one vertex, or at two.
      std::array<Normal, 3> n;
      for (int v = 0; v < 3; ++v) {
        for (int c = 0; c < 3; ++c) n[v][c] = (v == int(k + c) % 3) != (k / 3 % 2 == 1) ? light.most() : light.least();
      }
      add_normals(frame.lighting, 0, n[0], n[1], n[2]);
    }
  }
  return frames;
}

}  // namespace halfspace::model
