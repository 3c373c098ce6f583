// SPDX-License-Identifier: Apache-2.0
// Three formats of the reference, with the numbers of the named configurations.
#ifndef HALFSPACE_TESTS_GEOMETRY_THREE_FORMATS_HPP_
#define HALFSPACE_TESTS_GEOMETRY_THREE_FORMATS_HPP_

#include <algorithm>
#include <vector>

#include "ref/geometry/geometry.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::ref {

inline const RasterFormat kLow{"low", 320, 200, 4096, 10, 4, 16};
inline const RasterFormat kMiddle{"middle", 640, 480, 16384, 11, 8, 24};
inline const RasterFormat kHigh{"high", 1920, 1080, 262144, 14, 8, 24};
inline const std::vector<RasterFormat> kAll{kLow, kMiddle, kHigh};

inline View view_of(const RasterFormat& format) {
  return {format.width, format.height, format.range_bits, format.subpixel_bits};
}

inline std::size_t covered(const Frame& frame) {
  return frame.index.size() - std::count(frame.index.begin(), frame.index.end(), 0u);
}

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_GEOMETRY_THREE_FORMATS_HPP_
