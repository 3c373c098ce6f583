// SPDX-License-Identifier: Apache-2.0
// Picture files: by OpenImageIO (image_file.cpp), or, in a program that was built without it, PNG alone
// (image_file_png.cpp).
#ifndef HALFSPACE_REF_SCENE_IMAGE_FILE_HPP_
#define HALFSPACE_REF_SCENE_IMAGE_FILE_HPP_

#include <cstdint>
#include <string>
#include <vector>

namespace halfspace::ref {

struct Image {
  int width, height, channels;
  std::vector<std::uint8_t> bytes;  // row by row, all channels of a pixel together
};

constexpr int kLongestRead = 16384;  // pixels each way, so that a broken header asks for no more memory than there is

// A file, or the bytes of one. Error with the name.
Image read_image(const std::string& path);
Image read_image(const std::string& name, const std::vector<std::uint8_t>& bytes);

// The bytes of a file of that name, whose ending chooses the format. Three channels. Error with the name.
std::string encoded_image(const std::string& name, const Image& image);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_SCENE_IMAGE_FILE_HPP_
