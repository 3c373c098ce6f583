// SPDX-License-Identifier: Apache-2.0
// The numerical extremes: frames that need every bit of every width in hls/formats/formats.hpp, for any configuration.
// The note of a frame says which.
#ifndef HALFSPACE_VECTORS_FRAMES_EXTREMES_HPP_
#define HALFSPACE_VECTORS_FRAMES_EXTREMES_HPP_

#include <vector>

#include "model/pipeline/named_frame.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// Shapes: vectors/frames/extremes_shape.cpp
std::vector<NamedFrame> smallest_area_frames(const ref::RasterFormat&);
std::vector<NamedFrame> centre_frames(const ref::RasterFormat&);
std::vector<NamedFrame> box_frames(const ref::RasterFormat&);
std::vector<NamedFrame> sliver_frames(const ref::RasterFormat&);
std::vector<NamedFrame> guard_band_frames(const ref::RasterFormat&);
std::vector<NamedFrame> order_frames(const ref::RasterFormat&);
// Values: vectors/frames/extremes_value.cpp
std::vector<NamedFrame> reciprocal_frames(const ref::RasterFormat&);
std::vector<NamedFrame> gradient_frames(const ref::RasterFormat&);
std::vector<NamedFrame> equal_depth_frames(const ref::RasterFormat&);
std::vector<NamedFrame> full_scale_frames(const ref::RasterFormat&);
// Positions and sizes: vectors/frames/extremes_frame.cpp
std::vector<NamedFrame> snapped_frames(const ref::RasterFormat&);
std::vector<NamedFrame> frame_size_frames(const ref::RasterFormat&);
// Too large for the standard set: the largest frame, and the last index behind triangles without area.
std::vector<NamedFrame> largest_frames(const ref::RasterFormat&);

struct ExtremeClass {
  const char* name;
  std::vector<NamedFrame> (*frames)(const ref::RasterFormat&);
};
// All of them, largest_frames last.
const std::vector<ExtremeClass>& extreme_classes();

// All but largest_frames.
std::vector<NamedFrame> extreme_frames(const ref::RasterFormat& format);

// Vertices half a sub-pixel beside the centres of pixels, to either side, and a little less and more than half.
ref::TriangleList finer_than_the_grid(const ref::RasterFormat& format);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_EXTREMES_HPP_
