// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <png.h>

#include <filesystem>

#include "ref/error.hpp"
#include "ref/scene/image_file.hpp"

namespace halfspace::ref {
namespace {

// After png_image_begin_read_…, whose result is `begun`.
Image from_png(const std::string& name, png_image& png, bool begun) {
  if (!begun) {
    throw Error(
        fmt::format("{}: the texture cannot be read ({}); this program was built without OpenImageIO and reads "
                    "PNG alone: run setup/install.sh build and build it anew",
                    name, png.message));
  }
  if (png.width > kLongestRead || png.height > kLongestRead) {
    png_image_free(&png);
    throw Error(fmt::format("{}: a texture of {}x{} texels is not taken; scale it to 1x1 to {}x{}", name, png.width,
                            png.height, kLongestRead, kLongestRead));
  }
  png.format = PNG_FORMAT_RGBA;  // with three channels alpha would be blended
  Image image{int(png.width), int(png.height), 4, {}};
  image.bytes.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, image.bytes.data(), 0, nullptr)) {
    throw Error(fmt::format("{}: the texture cannot be read ({}); check the file", name, png.message));
  }
  return image;
}

png_image blank() {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  return png;
}

}  // namespace

Image read_image(const std::string& path) {
  png_image png = blank();
  return from_png(path, png, png_image_begin_read_from_file(&png, path.c_str()) != 0);
}

Image read_image(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  png_image png = blank();
  return from_png(name, png, png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) != 0);
}

std::string encoded_image(const std::string& name, const Image& image) {
  if (std::filesystem::path(name).extension() != ".png") {
    throw Error(fmt::format("{}: there is no picture format of that ending: use .png", name));
  }
  png_image png = blank();
  png.width = std::uint32_t(image.width);
  png.height = std::uint32_t(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.bytes.data(), 0, nullptr)) {
    throw Error(fmt::format("{}: cannot make the picture: {}", name, png.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace halfspace::ref
