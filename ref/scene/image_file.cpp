// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <string_view>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

struct Start {
  std::string_view bytes;
  const char* format;  // as OpenImageIO calls it
};
using namespace std::string_view_literals;
constexpr Start kStarts[] = {
    {"\x89PNG"sv, "png"}, {"\xFF\xD8\xFF"sv, "jpeg"},
    {"BM"sv, "bmp"},      {"GIF8"sv, "gif"},
    {"II*\0"sv, "tiff"},  {"MM\0*"sv, "tiff"},
    {"P1"sv, "pnm"},      {"P2"sv, "pnm"},
    {"P3"sv, "pnm"},      {"P4"sv, "pnm"},
    {"P5"sv, "pnm"},      {"P6"sv, "pnm"},
};
constexpr std::size_t kStartSize = 18;

// TGA has no word of its own at its start: kinds of colour table and of picture, and bits.
bool is_tga(std::string_view start) {
  if (start.size() < kStartSize) return false;
  const int table = start[1], kind = start[2] & ~8, bits = start[16];
  return (table == 0 || table == 1) && kind >= 1 && kind <= 3 &&
         (bits == 8 || bits == 15 || bits == 16 || bits == 24 || bits == 32);
}

// By what is in it: its name may say another format.
const char* format_of(const std::string& name, std::string_view start) {
  for (const Start& known : kStarts) {
    if (start.substr(0, known.bytes.size()) == known.bytes) return known.format;
  }
  if (is_tga(start)) return "targa";
  throw Error(fmt::format(
      "{}: a texture of this format is not taken; convert it to PNG, JPEG, BMP, GIF, TGA, TIFF or PPM", name));
}

// Colours as they stand in the file: OpenImageIO multiplies them by alpha unless it is told.
OIIO::ImageSpec as_they_stand() {
  OIIO::ImageSpec spec;
  spec["oiio:UnassociatedAlpha"] = 1;
  return spec;
}

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw Error(fmt::format("{}: the texture cannot be read ({}); check the file, or export the scene again", name,
                          one_line(reason)));
}

// By the reader of that format and no other. `bytes`: null, or what the file has in it.
Image from_format(const std::string& name, const char* format, OIIO::Filesystem::IOProxy* bytes) {
  const auto input = OIIO::ImageInput::create(format);
  if (!input) fail(name, OIIO::geterror());
  if (bytes && !input->set_ioproxy(bytes)) fail(name, fmt::format("{} inside of a file is not taken", format));
  OIIO::ImageSpec spec;
  if (!input->open(name, spec, as_they_stand())) fail(name, input->geterror());
  if (spec.width < 1 || spec.height < 1 || spec.width > kLongestRead || spec.height > kLongestRead ||
      spec.nchannels < 1) {
    throw Error(fmt::format("{}: a texture of {}x{} texels is not taken; scale it to 1x1 to {}x{}", name, spec.width,
                            spec.height, kLongestRead, kLongestRead));
  }
  Image image{spec.width, spec.height, spec.nchannels, {}};
  image.bytes.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.bytes.data())) {
    fail(name, input->geterror());
  }
  return image;
}

}  // namespace

Image read_image(const std::string& path) {
  char start[kStartSize];
  std::ifstream file(path, std::ios::binary);
  file.read(start, kStartSize);
  return from_format(path, format_of(path, {start, std::size_t(file.gcount())}), nullptr);
}

Image read_image(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  const auto* const start = reinterpret_cast<const char*>(bytes.data());
  const char* const format = format_of(name, {start, std::min(bytes.size(), kStartSize)});
  OIIO::Filesystem::IOMemReader reader(const_cast<std::uint8_t*>(bytes.data()), bytes.size());
  return from_format(name, format, &reader);
}

std::string encoded_image(const std::string& name, const Image& image) {
  const auto out = OIIO::ImageOutput::create(name);
  // To memory, so that nothing of a file is lost unseen: the formats that the library cannot write so are not taken.
  if (!out || !out->supports("ioproxy"))
    throw Error(fmt::format("{}: there is no picture format of that ending: use .png", name));
  const OIIO::ImageSpec spec(image.width, image.height, 3, OIIO::TypeDesc::UINT8);
  OIIO::Filesystem::IOVecOutput bytes;
  if (!out->set_ioproxy(&bytes) || !out->open(name, spec) ||
      !out->write_image(OIIO::TypeDesc::UINT8, image.bytes.data()) || !out->close()) {
    std::string reason = out->geterror();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw Error(fmt::format("{}: cannot make the picture: {}: use .png", name, reason));
  }
  return {reinterpret_cast<const char*>(bytes.buffer().data()), bytes.buffer().size()};
}

}  // namespace halfspace::ref
