// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/awkward.hpp"

#include <algorithm>
#include <random>

#include "model/texture/texture.hpp"

namespace halfspace::model {
namespace {

constexpr int kMostLoaded = 1 << 12;  // texels: the words of a frame are loaded before it

// One that fills the memory; or a half, a quarter, and as many small ones in the rest as there may be. Squares, and as
// long one way and the other as can be.
std::vector<RawTexture> awkward_textures(const Config& config, std::mt19937_64& random) {
  const int least = is_bilinear(config) ? 1 : 0, region = std::min(config.texels, kMostLoaded);
  // Of a large memory, a part.
  int base = region * int(random() % std::uint64_t(config.texels / region));
  std::vector<RawTexture> textures;
  const bool one = random() % 4 == 0;
  const int left = exact_log2(region);
  const int small = config.textures < 4 ? left - 2 : left - 2 - bits_for(config.textures - 3);
  for (int n = 0; n < config.textures; ++n) {
    const int size = one ? left : std::max(n < 2 ? left - 1 - n : small, 2 * least);
    RawTexture& texture = textures.emplace_back();
    const std::uint64_t kind = random() % 3;
    texture.log2_width = kind == 0 ? size / 2 : kind == 1 ? size - least : least;
    texture.log2_height = size - texture.log2_width;
    texture.base = base;
    base += 1 << size;
    if (one || base % region == 0) break;
  }
  return textures;
}

}  // namespace

TextureFrame awkward_coordinates(std::size_t triangles, const Config& config, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::int64_t n) { return int(random() % std::uint64_t(n)); };
  TextureFrame frame;
  frame.textures = awkward_textures(config, random);
  const int colours = 1 << config.colour_bits;
  for (const RawTexture& texture : frame.textures) {
    for (int n = 0; n < 1 << (texture.log2_width + texture.log2_height); ++n) {
      RawTexel& texel = frame.texels.emplace_back();
      texel.address = texture.base + n;
      for (auto& channel : texel.rgb)
        channel = std::uint8_t(random() % 4 == 0 ? below(2) * (colours - 1) : below(colours));
    }
  }
  const int full = (1 << config.coordinate_bits) - 1;
  for (std::size_t k = 0; k < triangles; ++k) {
    RawCoordinates& out = frame.triangles.emplace_back();
    out.texture = 1 + below(std::int64_t(frame.textures.size()));
    out.repeats = below(4);
    const int around = 1 + below(full);
    for (int v = 0; v < 3; ++v) {
      int q = full;
      switch (k % 8) {
        case 1: q = full / (1 + below(4)); break;
        case 2: q = std::max(full >> below(config.coordinate_bits), 1); break;  // any octave
        case 3: q = v == 0 ? full : 1; break;                                   // as far as can be
        case 4: q = std::clamp(around + below(3) - 1, 1, full); break;          // hardly differ
        case 5: q = 1 + below(full); break;
        default: break;
      }
      const int most = has_perspective(config) ? q : full;
      for (auto* coordinate : {&out.s, &out.t}) {
        int value = below(std::int64_t(most) + 1);
        if (k % 8 == 2 || k % 8 == 3) value = below(2) * most;
        if (k % 8 == 4) value = std::clamp(most / 2 + below(3) - 1, 0, most);
        (*coordinate)[v] = value;
      }
      out.q[v] = has_perspective(config) ? q : 0;
    }
    if (k % 8 == 5) out.repeats = (1 << kRepeatBits) - 1;
    if (k % 8 == 6) out.texture = 0;
  }
  return frame;
}

}  // namespace halfspace::model
