// SPDX-License-Identifier: Apache-2.0
// Frames in between as the kernels take and give them: where each triangle is in the key frames, and the motion field.
#ifndef HALFSPACE_MODEL_MOTION_MOTION_HPP_
#define HALFSPACE_MODEL_MOTION_MOTION_HPP_

#include <array>
#include <cstdint>
#include <vector>

#include "hls/formats/formats.hpp"
#include "ref/geometry/snap.hpp"
#include "ref/motion/of_keys.hpp"

// So that whoever takes frames alone does not see how scenes are read.
namespace halfspace::ref {
struct Between;
}

namespace halfspace::model {

// The raw bits of the records of the same names.
struct RawKeyPlaces {
  bool there = false;
  int origin_x = 0, origin_y = 0, extent = 0;
  std::array<int, 3> s{}, t{}, q{};                // of the vertices in the order given; affine: q is 0
  std::array<std::array<int, 3>, 3> difference{};  // of r, g, b, each of the vertices
};
struct RawMotionVectors {
  int face = 0;
  ref::OfKeys<RawKeyPlaces> key;
};

struct MotionFrame {
  std::vector<RawMotionVectors> triangles;
};

// The number of a face of the scene in key pixels and motion words: 1 … 2^face_bits − 1, again from 1 after that.
int face_number(std::uint32_t face, const Config& config);

// Of vertices at `place`, in pixels, and with `weight` = w at the key over w in between, all 1 without perspective. A
// triangle that leaves the range of positions there has no place in the key frame.
RawKeyPlaces quantized_places(const std::array<glm::dvec2, 3>& place, const std::array<double, 3>& weight,
                              const Config& config);

// Of the triangles of `between`. Affine: vertices are where they are snapped in either frame, as in ref::fixed_vectors;
// with perspective at their exact places. A triangle with a vertex nearer than the near plane at a key has no place
// there. `change` is of those triangles, with relight alone; empty, colours are the same at all times.
MotionFrame motion_frame(const ref::Between& between, const Config& config,
                         const ref::OfKeys<ref::LightChange>& change = {});

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_MOTION_MOTION_HPP_
