// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <memory>

#include "ref/error.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

Image from_input(const std::string& name, std::unique_ptr<OIIO::ImageInput> input) {
  if (!input) {
    throw Error(fmt::format("{}: the texture cannot be read ({}); check the file, or export the scene again", name,
                            one_line(OIIO::geterror())));
  }
  const OIIO::ImageSpec spec = input->spec();
  if (spec.width < 1 || spec.height < 1 || spec.width > kLongestRead || spec.height > kLongestRead ||
      spec.nchannels < 1) {
    throw Error(fmt::format("{}: a texture of {}x{} texels is not taken; scale it to 1x1 to {}x{}", name, spec.width,
                            spec.height, kLongestRead, kLongestRead));
  }
  Image image{spec.width, spec.height, spec.nchannels, {}};
  image.bytes.resize(std::size_t(spec.width) * spec.height * spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, image.bytes.data())) {
    throw Error(fmt::format("{}: the texture cannot be read ({}); check the file", name, one_line(input->geterror())));
  }
  return image;
}

}  // namespace

Image read_image(const std::string& path) { return from_input(path, OIIO::ImageInput::open(path)); }

Image read_image(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  // The ending chooses the reader: the two formats that scene files embed.
  const bool is_png = bytes.size() > 3 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G';
  OIIO::Filesystem::IOMemReader reader(const_cast<std::uint8_t*>(bytes.data()), bytes.size());
  return from_input(name, OIIO::ImageInput::open(is_png ? "embedded.png" : "embedded.jpg", nullptr, &reader));
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
