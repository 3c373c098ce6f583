// SPDX-License-Identifier: Apache-2.0
// Extremes of light. p: fraction bits of a component of a normal; u: those of a cosine; L, H: to a light, and between
// that and the viewer; k: squarings of a highlight.
#include <fmt/format.h>

#include "vectors/frames/features/feature_extremes.hpp"
#include "vectors/frames/features/light_builder.hpp"

namespace halfspace::model {

using ref::RasterFormat;
using Normal = LightBuilder::Normal;

std::vector<NamedFrame> normal_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const LightBuilder light(config);
  NamedFrame with;
  with.lighting.lights = light.axes();
  const int materials = std::min(light.squarings() + 2, config.materials);
  // The largest exponent first, and last one beyond what is built.
  for (int k = 0; k < materials; ++k)
    with.lighting.materials.push_back(
        light.colourful(k <= light.squarings() ? light.squarings() - k : light.most_gloss()));
  const int ends[5] = {0, 1, -1, light.most(), light.least()};
  push_cells(frames, "extreme: normals of length 0, of a unit of 2^−p, and the longest, along axes and diagonals",
             format, 125, 3, with, [&](NamedFrame& frame, int k, Point) {
               const Normal n{ends[k % 5], ends[k / 5 % 5], ends[k / 25]};
               add_normals(frame.lighting, k % materials, n, n, n);
             });
  // One direction in every length: each halving is one place more to shift.
  push_cells(frames, "extreme: normals of every length from a unit on, in one direction: k of 1/√q from p to 0", format,
             4 * config.normal_bits, 3, with, [&](NamedFrame& frame, int k, Point) {
               const int s = 1 << (k / 4), end = s - (k / 4 == config.normal_bits);
               const Normal ways[4] = {{end, end, end}, {-s, end / 2, end}, {0, -s, 0}, {end, 0, end}};
               add_normals(frame.lighting, k % materials, ways[k % 4], ways[k % 4], ways[k % 4]);
             });
  return frames;
}

std::vector<NamedFrame> light_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const LightBuilder light(config);
  const int far = light.far(), unit = far / 5, most = light.most(), least = light.least();
  {
    // (3, 0, 4) and (4, 0, −3) are at right angles, as words too, and the places between add j units of n·L. The
    // highlight is along the normal: all of it, or none.
    NamedFrame with;
    with.lighting.lights.assign(std::size_t(config.lights), {{3 * unit, 1, 4 * unit}, {4 * unit, 0, -3 * unit}});
    with.lighting.materials =
        light.fitted({light.material(0, 0, 0, light.full_colour() / config.lights),
                      light.material(light.squarings(), 0, 0, light.full_colour() / config.lights)});
    push_cells(frames, "extreme: light that grazes: n·L of −2 … 2 units, and the highlight at its largest", format, 40,
               3, with, [&](NamedFrame& frame, int k, Point) {
                 const int s = std::max(most / 4 >> (k / 5), 1);
                 const Normal n{4 * s, k % 5 - 2, -3 * s};
                 add_normals(frame.lighting, k % int(with.lighting.materials.size()), n, n, n);
               });
  }
  {
    // Directions longer than 1 are cut to a cosine of 1: all terms count whole, and the sum is what is asked for.
    NamedFrame with;
    with.lighting.lights.assign(std::size_t(config.lights), {{far, far, far}, {far, far, far}});
    const double half = double(light.half_sum()) / light.terms();
    const double white = double(light.full_colour()) / light.terms();
    with.lighting.materials = light.fitted(
        {light.half_sum_material(), light.material(0, 1e9, 1e9, 1e9), light.material(0, half + 1, half + 1, half + 1),
         light.material(0, white, white, white), light.material(0, white / 2, white / 2, white / 2)});
    push_cells(frames,
               "extreme: all lights at full scale: n·L of 3·2^(p+u+1), cosines of 1, sums of 2^(head−1) and at the end",
               format, 20, 3, with, [&](NamedFrame& frame, int k, Point) {
                 const Normal n = k < 10 ? Normal{most, most, most} : Normal{most, most, most - 1};
                 add_normals(frame.lighting, k % int(with.lighting.materials.size()), n, n, n);
               });
    push_cells(frames, "extreme: the same lights from behind: n·L of −3·2^(p+u+1)", format, 8, 3, with,
               [&](NamedFrame& frame, int k, Point) {
                 const Normal n = k % 2 ? Normal{least, least, least} : Normal{least, least, most};
                 add_normals(frame.lighting, 0, n, n, n);
               });
  }
  {
    // Straight at the light, of lengths about a power of two: n·L with 1 <= |n| < 2 at both ends.
    NamedFrame with;
    with.lighting.lights.assign(std::size_t(config.lights), {{0, 0, far}, {0, 0, far}});
    for (int k = 0; k <= light.squarings() + 1; ++k)
      with.lighting.materials.push_back(light.colourful(std::min(k, light.most_gloss())));
    with.lighting.materials = light.fitted(with.lighting.materials);
    const int materials = int(with.lighting.materials.size());
    push_cells(frames, "extreme: normals along a light: projections just below 2, of 1, and a cosine of 1", format,
               3 * config.normal_bits, 3, with, [&](NamedFrame& frame, int k, Point) {
                 const int z = std::clamp((1 << (k / 3)) + k % 3 - 1, 0, most);
                 add_normals(frame.lighting, k % materials, {0, 0, z}, {0, 0, z}, {0, 0, z});
               });
  }
  return frames;
}

std::vector<NamedFrame> material_extremes(const RasterFormat& format, const Config& config) {
  std::vector<NamedFrame> frames;
  const LightBuilder light(config);
  NamedFrame with;
  with.lighting.lights = light.axes();
  // A table without an empty row. Rounding: a half goes up, and full scale is the end.
  const double full = light.full_colour(), bases[8] = {0, full, full - 0.5, full + 0.25, 0.5, 2 * full + 7, 511, 1.5};
  for (int m = 0; m < config.materials; ++m) {
    RawMaterial material = light.material(0, 0, 0, 0);
    for (int c = 0; c < 3; ++c) {
      material.reflections[0].base[c] = light.coefficient(bases[(m + c + 3 * (2 * m / config.materials)) % 8]);
    }
    with.lighting.materials.push_back(material);
  }
  push_cells(frames, "extreme: all materials, with a base alone: 0, a half, full scale and beyond", format,
             std::min(config.materials, 128), 3, with, [&](NamedFrame& frame, int k, Point) {
               const int m = k % 2 ? config.materials - 1 - k / 2 : k / 2;
               add_normals(frame.lighting, m, {0, 0, 9}, {0, 0, 9}, {0, 0, 9});
             });
  // Four times full scale and half of that: clamped, and without its top bit not.
  with.lighting.materials.resize(std::min<std::size_t>(with.lighting.materials.size(), 2));
  const int top = (light.full_coefficient() + 1) / 2;
  for (RawMaterial& material : with.lighting.materials) {
    material = light.material(0, 0, 0, 0);
    const bool second = &material == &with.lighting.materials[1];
    if (second && has_gloss(config)) material.reflections[0].specular = {top, 0, 0};
    else material.reflections[0].diffuse = {top, 0, 0};
    material.reflections[0].base = {0, top, light.full_coefficient()};
  }
  const int far = light.far();
  with.lighting.lights.assign(std::size_t(config.lights), {{far, far, far}, {far, far, far}});
  push_cells(frames, "extreme: coefficients of twice full scale, and of four times", format, 4, 3, with,
             [&](NamedFrame& frame, int k, Point) {
               const int n = light.most();
               add_normals(frame.lighting, k % int(with.lighting.materials.size()), {n, n, n}, {n, n, n}, {n, n, n});
             });
  return frames;
}

}  // namespace halfspace::model
