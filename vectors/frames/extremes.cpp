// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/extremes.hpp"

namespace halfspace::model {

const std::vector<ExtremeClass>& extreme_classes() {
  static const std::vector<ExtremeClass> classes = {
      {"D of 0 to 4", smallest_area_frames},
      {"vertices and edges on centres", centre_frames},
      {"boxes of 127-129 pixels", box_frames},
      {"slivers", sliver_frames},
      {"ends of the guard band", guard_band_frames},
      {"orders of the vertices", order_frames},
      {"reciprocals", reciprocal_frames},
      {"gradients", gradient_frames},
      {"equal depths", equal_depth_frames},
      {"full scale", full_scale_frames},
      {"finer than the grid", snapped_frames},
      {"frame sizes", frame_size_frames},
      {"largest frame, last index", largest_frames},
  };
  return classes;
}

std::vector<NamedFrame> extreme_frames(const ref::RasterFormat& format) {
  std::vector<NamedFrame> frames;
  for (const ExtremeClass& one : extreme_classes()) {
    if (one.frames == largest_frames) continue;
    for (NamedFrame& frame : one.frames(format)) frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace halfspace::model
