// SPDX-License-Identifier: Apache-2.0
// Motion compensation: the pixels of a frame between two keys, fetched from the keys along the motion field.
#ifndef HALFSPACE_REF_MOTION_COMPENSATE_HPP_
#define HALFSPACE_REF_MOTION_COMPENSATE_HPP_

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "ref/motion/motion_field.hpp"
#include "ref/motion/quality.hpp"

namespace halfspace::ref {

enum class Filter {
  kNearest,
  kBilinear,
  kArea,
  kBicubic,
  kFootprint,  // bilinear at places all over the pixel as the motion carries it, if that makes it larger
};
constexpr Filter kFilters[] = {Filter::kNearest, Filter::kBilinear, Filter::kArea, Filter::kBicubic,
                               Filter::kFootprint};
const char* name_of(Filter);  // "nearest", …

// width · height pixels, row 0 on top. Identity and colour are of one thing that the pixel shows.
struct KeyFrame {
  int width, height;
  Colours colour;
  std::vector<std::uint32_t> identity;  // of what the pixel shows; 0 matches nothing
};

// What a tap is the same surface by: the identity of each face of the scene at its number; 0 at 0.
using Identities = std::vector<std::uint32_t>;

// What counts for a tap along one axis: 2 of them, bicubic 4. The fraction t is that of the place beyond the centre of
// the pixel before it. Sums to 1.
//   bilinear 1 − t, t: the areas that a footprint of one pixel has in common with both;
//   area     these over the distance, t and 1 − t, and scaled to 1: (1 − t)², t² over their sum;
//   bicubic  Catmull-Rom, of which the outer two are not positive.
std::array<double, 2> axis_weights(Filter, double t);
std::array<double, 4> cubic_weights(double t);

struct CompensationMode {
  Filter filter = Filter::kBilinear;
  bool index_test = true;        // else each tap in the frame matches
  OfKeys<bool> use{true, true};  // a key that is not used shows nothing
  double least_weight = 0;       // of the taps that match together, for the key to show the point
  bool render_holes = true;      // else what no key shows is taken as without the index test
};

// The colour of a key at a place in pixels, 0-255, as `identity` has it; none if the key does not show it. Of a place
// alone a footprint is a bilinear filter. docs/frames.md has the rules.
std::optional<glm::dvec3> fetch(const KeyFrame&, const glm::dvec2& place, std::uint32_t identity,
                                const CompensationMode&);

// What is added to what a key shows, for each pixel of the field; empty: nothing.
using LightPlanes = OfKeys<std::vector<glm::dvec3>>;

struct Shares {
  // Pixels of the field; of a frame with samples a pixel, samples.
  std::uint64_t background = 0, blended = 0, copied = 0, filled = 0;
  std::uint64_t still = 0;  // of what stands still, with a static buffer
  // Pixels of the picture: that the field covers, and of these any sample of which was filled.
  std::uint64_t pixels = 0, rendered = 0;
};

struct Compensated {
  Colours colour;
  std::vector<std::uint8_t> keys;  // bit k: key k has a part in the pixel
  Shares shares;
};

// Keys have a whole number of pixels for one of the field, or the other way round. `a` is how far the frame is from the
// first key to the second. A pixel that no key shows is asked of `second`, if there are such: the same keys, of other
// things that their pixels show. One that these do not show either is taken from `rendered`, the frame between as it is
// rendered; so is the background.
Compensated compensate(const OfKeys<KeyFrame>&, const MotionField&, const Identities&, double a,
                       const CompensationMode&, const LightPlanes&, const Colours& rendered,
                       const OfKeys<KeyFrame>* second = nullptr);

// Pixels of a picture of `samples` each way that keys have a part in, and what is rendered for want of a key has not.
// `keys` as Compensated has it, `face` of the field. Counts the pixels in `shares`.
std::vector<bool> made_of_keys(const std::vector<std::uint8_t>& keys, const std::vector<std::uint32_t>& face, int width,
                               int height, int samples, Shares& shares);

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_MOTION_COMPENSATE_HPP_
