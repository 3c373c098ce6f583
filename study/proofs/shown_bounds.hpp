// SPDX-License-Identifier: Apache-2.0
// From snapped vertices, and the words that come with them, to the colour that is shown: what the stages before it add
// up to. docs/bounds.md has the composition.
#ifndef HALFSPACE_STUDY_PROOFS_SHOWN_BOUNDS_HPP_
#define HALFSPACE_STUDY_PROOFS_SHOWN_BOUNDS_HPP_

#include "hls/formats/formats.hpp"
#include "study/proofs/bounds_proved.hpp"

namespace halfspace::model {

// Of the colour before texture, in LSB: 0 where a triangle has one that comes with it. With lighting, of one white
// light; with Phong shading as white_phong().
Dyadic surface_bound(const Config& config);

// Of the product with a texel, in LSB, from those of the colour and of the texel as it is filtered: |shown − L·T/full|.
double textured_bound(const Config& config, double surface, double texel);
// Of a filtered texel, in LSB, whose place is off by `u` and `v` texels where neighbours differ by `du` and `dv` LSB.
double texel_bound(const Config& config, double u, double v, double du, double dv);

// The texture that the printed bound is of: a square of 64 × 64 texels or what the memory holds, of any colours.
constexpr int shown_side(const Config& config) {
  return exact_log2(config.texels) / 2 < 6 ? exact_log2(config.texels) / 2 : 6;  // log2
}

// How fast a filter of key frames changes along an axis, in colours of full scale a pixel of the key frame; of the
// nearest, 0: where it is decided.
double key_slope(KeyFilter filter);
// Of a pixel in between, in LSB, from one of its keys that shows the point with all pixels of the filter.
double between_bound(const Config& config, double vector_x, double vector_y, double difference);

// The parts of the printed bound: of a filtered texel, where it lies, how far texels differ, the product; and of a key,
// the vector in pixels of it, how fast it changes, relighting.
struct ShownTexel {
  Dyadic filter, place, apart, texel, product;
};
ShownTexel shown_texel(const Config& config);
struct ShownKey {
  Dyadic colour, place, slope, difference;
};
ShownKey shown_key(const Config& config);
// In LSB, of what configurations of all kinds show.
Dyadic shown_bound(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PROOFS_SHOWN_BOUNDS_HPP_
