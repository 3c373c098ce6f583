// SPDX-License-Identifier: Apache-2.0
// Pictures of a frame.
#ifndef HALFSPACE_CLI_PLOTS_PICTURE_HPP_
#define HALFSPACE_CLI_PLOTS_PICTURE_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ref/raster/raster.hpp"

namespace halfspace::cli {

struct Picture {
  int width, height;
  std::vector<std::array<std::uint8_t, 3>> pixels;
};

Picture colour_picture(const ref::Frame& frame);
Picture picture_of(const std::vector<std::array<std::uint8_t, 4>>& colours, int width, int height);
// Flat colours, one a triangle, from a hash of the index; the background is black.
Picture index_picture(const ref::Frame& frame);
// Near is light, far is dark, stretched over the depths that are there; the background is blue.
Picture depth_picture(const ref::Frame& frame);
// 128 + gain·(a − b), clamped: grey where they are equal.
Picture difference_picture(const Picture& a, const Picture& b, int gain);

// The bytes of a file of that name; the format follows from the ending. Throws ref::Error.
std::string encoded(const std::string& name, const Picture& picture);
// Of a device or pipe without an ending a PNG. Whole or not at all; throws ref::Error.
void write_picture(const std::string& path, const Picture& picture);

}  // namespace halfspace::cli

#endif  // HALFSPACE_CLI_PLOTS_PICTURE_HPP_
