// SPDX-License-Identifier: Apache-2.0
#ifndef HALFSPACE_REF_SCENE_TEXTURE_HPP_
#define HALFSPACE_REF_SCENE_TEXTURE_HPP_

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace halfspace::ref {

// A picture that repeats over the plane. Texel (i, j) covers [i, i + 1] x [j, j + 1] texels, row 0 at v = 0.
struct Texture {
  std::string name;
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> texels;  // r, g, b; row by row

  // At whole coordinates, which repeat.
  const std::array<std::uint8_t, 3>& at(std::int64_t i, std::int64_t j) const;
};

// Any file that read_image reads, or the bytes of one; grey becomes r = g = b, alpha is left out. Error with the name
// of the file. `flip`: row 0 of the file is at v = 1.
Texture read_texture(const std::string& path, bool flip);
Texture read_texture(const std::string& name, const std::vector<std::uint8_t>& bytes, bool flip);

struct MeanColour {
  glm::dvec3 colour{0};  // 0-1
  bool is_uniform = true;
};
MeanColour mean_colour(const Texture&);

// To other sides: a texel is the mean of what it covers.
Texture resampled(const Texture& texture, int width, int height);

enum class TextureFilter { kNearest, kBilinear };
// 0-255 a channel, at (u, v) in units of the texture's sides; bilinear between the centres of four texels. Adds the
// texels.
glm::dvec3 sample(const Texture&, const glm::dvec2& uv, TextureFilter, std::uint64_t& texels);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_TEXTURE_HPP_
