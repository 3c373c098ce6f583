// SPDX-License-Identifier: Apache-2.0
// Frames as the reference draws them, and key frames made of them.
#ifndef HALFSPACE_REF_MOTION_DRAWN_FRAME_HPP_
#define HALFSPACE_REF_MOTION_DRAWN_FRAME_HPP_

#include <cstdint>
#include <optional>
#include <vector>

#include "ref/geometry/surface.hpp"
#include "ref/motion/compensate.hpp"

namespace halfspace::ref {

struct Look {
  RasterFormat format;
  ShadingMode shading = ShadingMode::kGouraud;
  std::optional<TextureMode> texture = std::nullopt;  // the scene was loaded with its textures
};

struct DrawnFrame {
  int width, height;
  Colours colour;
  std::vector<std::uint32_t> face;  // of the scene; 0: background
};

// Of the geometry's own view.
DrawnFrame draw_frame(Geometry&, const Look&);

// A pixel for samples x samples: their mean, rounded half up.
Colours averaged(const Colours&, int width, int height, int samples);

// A pixel for samples x samples. Of the identities that it shows the one with the most of its samples, of as many the
// one whose first sample comes first, row by row; and the mean of that one's own samples, rounded half up. What shows
// nothing has identity 0, and the mean of all.
KeyFrame key_frame(const DrawnFrame&, int samples, const Identities&);
// Likewise of the identity that comes next by that order; 0 where there is but one.
KeyFrame second_key_frame(const DrawnFrame&, int samples, const Identities&);
// The mean of all samples; a pixel that shows more than one identity, or the background too, has 0.
KeyFrame pure_key_frame(const DrawnFrame&, int samples, const Identities&);

// The number of the face itself.
Identities face_identities(const Scene&);
// A group of faces of one instance that are smooth together: from one to the next by vertices of the same place and
// normal. Numbered from 1 on, in the order of their first faces.
Identities surface_identities(const Scene&);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_DRAWN_FRAME_HPP_
