// SPDX-License-Identifier: Apache-2.0
// Frames of texture: what the kernels take beside a snapped list, the coordinates of each triangle and the texture
// memory.
#ifndef HALFSPACE_MODEL_TEXTURE_TEXTURE_HPP_
#define HALFSPACE_MODEL_TEXTURE_TEXTURE_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "hls/formats/formats.hpp"
#include "ref/scene/texture.hpp"

// So that whoever takes frames alone does not see how scenes are read.
namespace halfspace::ref {
class Geometry;
struct Scene;
}  // namespace halfspace::ref

namespace halfspace::model {

// The raw bits of the records of the same names.
struct RawCoordinates {
  int texture = 0, repeats = 0;
  std::array<int, 3> s{}, t{}, q{};  // of the vertices in the order given; affine: q is 0
};
struct RawTexture {
  int base = 0, log2_width = 0, log2_height = 0;
};

struct RawTexel {
  int address = 0;
  std::array<std::uint8_t, 3> rgb{};
};

struct TextureFrame {
  std::vector<RawTexture> textures;  // number 1 first
  std::vector<RawTexel> texels;      // the memory, as far as it is used
  std::vector<RawCoordinates> triangles;
};

// Textures as a configuration can hold them: sides of powers of two, and halved, the largest first, until all have
// room. The reference then shows what the kernels do. Returns a sentence for each that lost texels. Throws ref::Error
// where there are too many.
std::vector<std::string> fit_textures(ref::Scene& scene, const Config& config);

// From coordinates and the w of the vertices. Throws ref::Error, beginning with `where`, if they span too many
// repetitions.
RawCoordinates quantized_coordinates(const std::array<glm::dvec2, 3>& uv, const std::array<double, 3>& w,
                                     const Config& config, const std::string& where);

// What loads the memory and the table, of textures that fit_textures has seen.
TextureFrame loaded_textures(const std::vector<ref::Texture>& textures, const Config& config);
// And the triangles of a geometry.
TextureFrame texture_frame(const ref::Geometry& geometry, const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_TEXTURE_TEXTURE_HPP_
