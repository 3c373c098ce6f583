// SPDX-License-Identifier: Apache-2.0
#include "cli/plots/picture.hpp"

#include <algorithm>
#include <filesystem>

#include "ref/scene/image_file.hpp"
#include "vectors/staging.hpp"

namespace halfspace::cli {
namespace {

Picture blank(const ref::Frame& frame) {
  return {frame.width, frame.height, std::vector<std::array<std::uint8_t, 3>>(frame.index.size())};
}

}  // namespace

Picture picture_of(const std::vector<std::array<std::uint8_t, 4>>& colours, int width, int height) {
  Picture picture{width, height, {}};
  for (const auto& c : colours) picture.pixels.push_back({c[0], c[1], c[2]});
  return picture;
}

Picture colour_picture(const ref::Frame& frame) { return picture_of(frame.colour, frame.width, frame.height); }

Picture index_picture(const ref::Frame& frame) {
  Picture picture = blank(frame);
  for (std::size_t n = 0; n < frame.index.size(); ++n) {
    if (frame.index[n] == 0) continue;
    // Multiplicative hash (Knuth): neighbouring indices get unlike colours. 64 keeps them off the background.
    const std::uint32_t hash = frame.index[n] * 2654435761u;
    picture.pixels[n] = {std::uint8_t(64 + (hash >> 8) % 192), std::uint8_t(64 + (hash >> 16) % 192),
                         std::uint8_t(64 + (hash >> 24) % 192)};
  }
  return picture;
}

Picture depth_picture(const ref::Frame& frame) {
  Picture picture = blank(frame);
  std::uint32_t nearest = ~0u, farthest = 0;
  for (std::size_t n = 0; n < frame.depth.size(); ++n) {
    if (frame.index[n] == 0) continue;
    nearest = std::min(nearest, frame.depth[n]);
    farthest = std::max(farthest, frame.depth[n]);
  }
  for (std::size_t n = 0; n < frame.depth.size(); ++n) {
    if (frame.index[n] == 0) {
      picture.pixels[n] = {20, 30, 70};
      continue;
    }
    const double range = std::max(1.0, double(farthest) - nearest);
    const auto grey = std::uint8_t(250 - 215 * (frame.depth[n] - nearest) / range);
    picture.pixels[n] = {grey, grey, grey};
  }
  return picture;
}

Picture difference_picture(const Picture& a, const Picture& b, int gain) {
  Picture picture = a;
  for (std::size_t n = 0; n < a.pixels.size(); ++n) {
    for (int c = 0; c < 3; ++c) {
      picture.pixels[n][c] = std::uint8_t(std::clamp(128 + gain * (int(a.pixels[n][c]) - b.pixels[n][c]), 0, 255));
    }
  }
  return picture;
}

std::string encoded(const std::string& name, const Picture& picture) {
  ref::Image image{picture.width, picture.height, 3, {}};
  image.bytes.reserve(3 * picture.pixels.size());
  for (const auto& pixel : picture.pixels) image.bytes.insert(image.bytes.end(), pixel.begin(), pixel.end());
  return ref::encoded_image(name, image);
}

void write_picture(const std::string& path, const Picture& picture) {
  model::StagedFile file(path);
  const bool has_ending = std::filesystem::path(path).has_extension();
  file.write(encoded(file.is_stream() && !has_ending ? path + ".png" : path, picture));
  file.commit();
}

}  // namespace halfspace::cli
