// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/texture.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ref/error.hpp"

namespace halfspace::ref {
namespace {

constexpr int kLongestRead = 16384;  // texels each way, so that a broken header asks for no more memory than there is

std::int64_t wrapped(std::int64_t i, std::int64_t size) { return (i % size + size) % size; }

Texture from_input(const std::string& name, std::unique_ptr<OIIO::ImageInput> input, bool flip) {
  if (!input) {
    throw Error(fmt::format("{}: the texture cannot be read ({}); check the file, or export the scene again", name,
                            OIIO::geterror()));
  }
  const OIIO::ImageSpec spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > kLongestRead || spec.height > kLongestRead ||
      spec.nchannels < 1) {
    throw Error(fmt::format("{}: a texture of {}x{} texels is not taken; scale it to 1x1 to {}x{}", name, spec.width,
                            spec.height, kLongestRead, kLongestRead));
  }
  std::vector<std::uint8_t> bytes(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, bytes.data())) {
    throw Error(fmt::format("{}: the texture cannot be read ({}); check the file", name, input->geterror()));
  }
  Texture texture{name, spec.width, spec.height, {}};
  texture.texels.resize(std::size_t(spec.width) * spec.height);
  for (int y = 0; y < spec.height; ++y) {
    for (int x = 0; x < spec.width; ++x) {
      const std::uint8_t* const pixel = &bytes[(std::size_t(y) * spec.width + x) * spec.nchannels];
      auto& texel = texture.texels[std::size_t(flip ? spec.height - 1 - y : y) * spec.width + x];
      for (int c = 0; c < 3; ++c) texel[c] = pixel[spec.nchannels < 3 ? 0 : c];
    }
  }
  return texture;
}

}  // namespace

const std::array<std::uint8_t, 3>& Texture::at(std::int64_t i, std::int64_t j) const {
  return texels[std::size_t(wrapped(j, height)) * width + wrapped(i, width)];
}

Texture read_texture(const std::string& path, bool flip) {
  return from_input(path, OIIO::ImageInput::open(path), flip);
}

Texture read_texture(const std::string& name, const std::vector<std::uint8_t>& bytes, bool flip) {
  // The ending chooses the reader: the two formats that scene files embed.
  const bool is_png = bytes.size() > 3 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G';
  OIIO::Filesystem::IOMemReader reader(const_cast<std::uint8_t*>(bytes.data()), bytes.size());
  return from_input(name, OIIO::ImageInput::open(is_png ? "embedded.png" : "embedded.jpg", nullptr, &reader), flip);
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
