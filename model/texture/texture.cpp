// SPDX-License-Identifier: Apache-2.0
#include "model/texture/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {
namespace {

// Of two sides 2^width and 2^height.
struct Sides {
  int width, height;
  std::int64_t texels() const { return std::int64_t(1) << (width + height); }
};

// A bilinear filter has a bank for each parity of a column and a row: a side of 1 is repeated.
int least_side(const Config& config) { return is_bilinear(config) ? 1 : 0; }

// The memory address of a texel: TextureMemory.
int address_of(const RawTexture& texture, int i, int j, const Config& config) {
  if (!is_bilinear(config)) return texture.base | j << texture.log2_width | i;
  return texture.base | (j / 2 << (texture.log2_width - 1) | i / 2) << 2 | j % 2 << 1 | i % 2;
}

}  // namespace

std::vector<std::string> fit_textures(ref::Scene& scene, const Config& config) {
  if (int(scene.textures.size()) > config.textures) {
    throw ref::Error(fmt::format("{}: {} textures, and configuration {} has {}: raise its textures", scene.name,
                                 scene.textures.size(), config.name, config.textures));
  }
  std::vector<Sides> sides;
  for (const ref::Texture& texture : scene.textures) {
    sides.push_back({std::max(bits_for(texture.width) - 1, least_side(config)),
                     std::max(bits_for(texture.height) - 1, least_side(config))});
  }
  const auto total = [&] {
    return std::accumulate(sides.begin(), sides.end(), std::int64_t(0),
                           [](std::int64_t sum, const Sides& s) { return sum + s.texels(); });
  };
  while (total() > config.texels) {
    Sides& largest = *std::max_element(sides.begin(), sides.end(),
                                       [](const Sides& a, const Sides& b) { return a.texels() < b.texels(); });
    const Sides half{std::max(largest.width - 1, least_side(config)), std::max(largest.height - 1, least_side(config))};
    if (half.texels() == largest.texels()) {
      throw ref::Error(
          fmt::format("{}: {} textures have no room in the {} texels of configuration {}: raise its texels", scene.name,
                      scene.textures.size(), config.texels, config.name));
    }
    largest = half;
  }
  std::vector<std::string> warnings;
  for (std::size_t n = 0; n < sides.size(); ++n) {
    ref::Texture& texture = scene.textures[n];
    const int width = 1 << sides[n].width, height = 1 << sides[n].height;
    if (width == texture.width && height == texture.height) continue;
    if (width < texture.width || height < texture.height) {
      warnings.push_back(fmt::format(
          "{}: {}x{} texels are scaled to {}x{}: configuration {} has {} texels, and sides of powers of two",
          texture.name, texture.width, texture.height, width, height, config.name, config.texels));
    }
    texture = ref::resampled(texture, width, height);
  }
  return warnings;
}

RawCoordinates quantized_coordinates(const std::array<glm::dvec2, 3>& uv, const std::array<double, 3>& w,
                                     const Config& config, const std::string& where) {
  RawCoordinates out;
  glm::dvec2 least(uv[0]), most(uv[0]);
  for (int v = 1; v < 3; ++v) least = glm::min(least, uv[v]), most = glm::max(most, uv[v]);
  const glm::dvec2 whole = glm::floor(least);
  const double span = std::max(most.x - whole.x, most.y - whole.y);
  const int repeats = (1 << kRepeatBits) - 1;
  if (!(span <= std::ldexp(1.0, repeats))) {
    throw ref::Error(
        fmt::format("{} spans {:.0f} repetitions of its texture, and at most {} can be: divide the triangle, or its "
                    "texture coordinates",
                    where, span, 1 << repeats));
  }
  while (span > std::ldexp(1.0, out.repeats)) ++out.repeats;
  const double full = std::ldexp(1.0, config.coordinate_bits) - 1;
  const double nearest = *std::min_element(w.begin(), w.end());
  for (int v = 0; v < 3; ++v) {
    const glm::dvec2 part =
        glm::dvec2(std::ldexp(uv[v].x - whole.x, -out.repeats), std::ldexp(uv[v].y - whole.y, -out.repeats));
    double scale = full + 1;
    if (has_perspective(config)) scale = out.q[v] = int(std::max(std::floor(full * nearest / w[v] + 0.5), 1.0));
    out.s[v] = int(std::min(std::floor(part.x * scale + 0.5), full));
    out.t[v] = int(std::min(std::floor(part.y * scale + 0.5), full));
  }
  return out;
}

TextureFrame loaded_textures(const std::vector<ref::Texture>& textures, const Config& config) {
  TextureFrame frame;
  frame.textures.resize(textures.size());
  // The largest first: each begins at a multiple of its size.
  std::vector<std::size_t> order(textures.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return textures[a].texels.size() > textures[b].texels.size(); });
  int base = 0;
  for (const std::size_t n : order) {
    const ref::Texture& texture = textures[n];
    RawTexture& out = frame.textures[n];
    out = {base, exact_log2(texture.width), exact_log2(texture.height)};
    base += texture.width * texture.height;
    for (int j = 0; j < texture.height; ++j) {
      for (int i = 0; i < texture.width; ++i) {
        RawTexel& texel = frame.texels.emplace_back();
        texel.address = address_of(out, i, j, config);
        for (int c = 0; c < 3; ++c) texel.rgb[c] = ref::snapped_colour(texture.at(i, j)[c], config.colour_bits);
      }
    }
  }
  return frame;
}

TextureFrame texture_frame(const ref::Geometry& geometry, const Config& config) {
  TextureFrame frame = loaded_textures(geometry.scene().textures, config);
  for (std::size_t k = 0; k < geometry.positions().triangles.size(); ++k) {
    RawCoordinates& out = frame.triangles.emplace_back();
    if (geometry.texture(k) < 0) continue;
    out = quantized_coordinates(geometry.uv(k), geometry.origins()[k].w, config,
                                fmt::format("{}: triangle {}", geometry.scene().name, k + 1));
    out.texture = geometry.texture(k) + 1;
  }
  return frame;
}

}  // namespace halfspace::model
