// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/texture.hpp"

#include <algorithm>
#include <cmath>

#include "ref/scene/image_file.hpp"

namespace halfspace::ref {
namespace {

std::int64_t wrapped(std::int64_t i, std::int64_t size) { return (i % size + size) % size; }

Texture from_image(const std::string& name, const Image& image, bool flip) {
  Texture texture{name, image.width, image.height, {}};
  texture.texels.resize(std::size_t(image.width) * image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* const pixel = &image.bytes[(std::size_t(y) * image.width + x) * image.channels];
      auto& texel = texture.texels[std::size_t(flip ? image.height - 1 - y : y) * image.width + x];
      for (int c = 0; c < 3; ++c) texel[c] = pixel[image.channels < 3 ? 0 : c];
    }
  }
  return texture;
}

}  // namespace

const std::array<std::uint8_t, 3>& Texture::at(std::int64_t i, std::int64_t j) const {
  return texels[std::size_t(wrapped(j, height)) * width + wrapped(i, width)];
}

Texture read_texture(const std::string& path, bool flip) { return from_image(path, read_image(path), flip); }

Texture read_texture(const std::string& name, const std::vector<std::uint8_t>& bytes, bool flip) {
  return from_image(name, read_image(name, bytes), flip);
}

MeanColour mean_colour(const Texture& texture) {
  MeanColour mean;
  for (const auto& texel : texture.texels) {
    mean.colour += glm::dvec3(texel[0], texel[1], texel[2]);
    mean.is_uniform = mean.is_uniform && texel == texture.texels.front();
  }
  mean.colour /= 255.0 * double(texture.texels.size());
  return mean;
}

Texture resampled(const Texture& texture, int width, int height) {
  Texture out{texture.name, width, height, {}};
  out.texels.reserve(std::size_t(width) * height);
  const std::int64_t w = texture.width, h = texture.height;
  for (std::int64_t j = 0; j < height; ++j) {
    for (std::int64_t i = 0; i < width; ++i) {
      // In a grid in which a texel of the one is width × height cells, and one of the other w × h.
      std::array<std::int64_t, 3> sum{};
      for (std::int64_t y = j * h / height; y * height < (j + 1) * h; ++y) {
        const std::int64_t rows = std::min((y + 1) * height, (j + 1) * h) - std::max(y * height, j * h);
        for (std::int64_t x = i * w / width; x * width < (i + 1) * w; ++x) {
          const std::int64_t cells = rows * (std::min((x + 1) * width, (i + 1) * w) - std::max(x * width, i * w));
          const auto& texel = texture.at(x, y);
          for (int c = 0; c < 3; ++c) sum[c] += cells * texel[c];
        }
      }
      auto& texel = out.texels.emplace_back();
      for (int c = 0; c < 3; ++c) texel[c] = std::uint8_t((sum[c] + w * h / 2) / (w * h));
    }
  }
  return out;
}

glm::dvec3 sample(const Texture& texture, const glm::dvec2& uv, TextureFilter filter, std::uint64_t& texels) {
  const double x = uv.x * texture.width, y = uv.y * texture.height;
  const auto colour = [&](std::int64_t i, std::int64_t j) {
    const auto& t = texture.at(i, j);
    ++texels;
    return glm::dvec3(t[0], t[1], t[2]);
  };
  if (filter == TextureFilter::kNearest) return colour(std::int64_t(std::floor(x)), std::int64_t(std::floor(y)));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5);
  const double a = x - 0.5 - left, b = y - 0.5 - top;
  const std::int64_t i = std::int64_t(left), j = std::int64_t(top);
  return (1 - b) * ((1 - a) * colour(i, j) + a * colour(i + 1, j)) +
         b * ((1 - a) * colour(i, j + 1) + a * colour(i + 1, j + 1));
}

}  // namespace halfspace::ref
