// SPDX-License-Identifier: Apache-2.0
// The kernels on one triangle, for any configuration: what each of them sends, as plain integers.
#ifndef HALFSPACE_STUDY_BOUNDS_BOUNDS_PROBE_HPP_
#define HALFSPACE_STUDY_BOUNDS_BOUNDS_PROBE_HPP_

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "hls/formats/config.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// A plane as it is kept: b + g bits at the centre of pixel (x, y), ½ included, and its steps of a pixel.
struct ProbedPlane {
  std::uint64_t start;
  std::int64_t dx, dy;
  int x, y;
};

// Of triangle_setup and shade_setup.
struct ProbedSetup {
  bool empty = true;  // the rest then means nothing
  int shift;
  std::uint64_t reciprocal;
  std::array<std::int64_t, 3> e, e_dx, e_dy;  // at the centre of the pixel of depth.x, depth.y
  ProbedPlane depth;
  std::array<ProbedPlane, 3> colour;  // with Phong shading of normals, which are normal_of_colour() of the colours
};

// Of raster_pineda and the shader.
struct ProbedPixel {
  int x, y;
  std::uint32_t depth;
  std::array<std::uint32_t, 3> colour;  // with Phong shading the normal before it is lit, 2^p units added
};

// A component of a normal, 2^p units added, for a channel of 0 … 2^colour_bits − 1.
constexpr int normal_of_colour(const Config& config, int colour) {
  return colour * (((1 << normal_plane_bits(config)) - 1) / ((1 << config.colour_bits) - 1));
}

class KernelProbe {
 public:
  virtual ~KernelProbe() = default;
  virtual void set_frame(int width, int height) = 0;
  // The reciprocal is that of hls/setup/reciprocal.hpp called apart: not every configuration has it in a stream.
  virtual ProbedSetup setup(const ref::SnappedTriangle& triangle) = 0;
  // The covered pixels of the triangle that setup() was given last, in the order and as often as they are sent.
  virtual std::vector<ProbedPixel> pixels() = 0;
};

// With the lanes of the configuration.
std::unique_ptr<KernelProbe> make_kernel_probe(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_PROBE_HPP_
