// SPDX-License-Identifier: Apache-2.0
// The last frame that the RTL sent, as a picture, and where it is wrong.
#ifndef HALFSPACE_TB_REPORT_PICTURE_HPP_
#define HALFSPACE_TB_REPORT_PICTURE_HPP_

#include <string>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

// The words received of the stream that is shown, as RGBA of 8 bits, row 0 on top. A pixel that never came is 0.
std::string rgba_picture(const Vectors& vectors, const Words& shown);
// Of `scan`: u32 a pixel.
std::string index_picture(const Vectors& vectors, const Words& scan);
// A PNG file of RGBA bytes.
std::string png_of(std::uint32_t width, std::uint32_t height, const std::string& rgba);

// Of each pixel of the last frame: 0 right, 1 wrong, 2 never came.
std::string wrong_pixels(const Vectors& vectors, const Words& shown);
// The same as RGBA: the picture expected, grey and dark, wrong pixels red, those that never came blue.
std::string map_of_wrong(const Vectors& vectors, const std::string& wrong);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_PICTURE_HPP_
