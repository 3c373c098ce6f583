// SPDX-License-Identifier: Apache-2.0
// The kernels on one triangle, for any configuration: what each of them sends, as plain integers.
#ifndef HALFSPACE_STUDY_BOUNDS_BOUNDS_PROBE_HPP_
#define HALFSPACE_STUDY_BOUNDS_BOUNDS_PROBE_HPP_

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "hls/formats/config.hpp"
#include "model/motion/motion.hpp"
#include "model/motion/motion_words.hpp"
#include "model/shade/lighting.hpp"
#include "model/texture/texture.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::model {

// A plane as it is kept: b + g bits at the centre of pixel (x, y), ½ included, and its steps of a pixel.
struct ProbedPlane {
  std::uint64_t start;
  std::int64_t dx, dy;
  int x, y;
};

// Of triangle_setup and of what sets up planes after it.
struct ProbedSetup {
  bool empty = true;  // the rest then means nothing
  int shift;
  std::uint64_t reciprocal;
  std::array<std::int64_t, 3> e, e_dx, e_dy;  // at the centre of the pixel of depth.x, depth.y
  ProbedPlane depth;
  std::array<ProbedPlane, 3> colour;      // with Phong shading of normals
  std::array<ProbedPlane, 3> coordinate;  // s, t, q of a texture, or of a place in key frame 0
  std::array<ProbedPlane, 3> difference;  // of colours, from key frame 0
};

// Of raster_pineda and what shades: values as they are rounded at a pixel.
struct ProbedPixel {
  int x, y;
  std::uint32_t depth;
  std::array<std::uint32_t, 3> colour;  // with Phong shading the normal before it is lit, 2^p units added
  std::array<std::uint32_t, 3> coordinate, difference;
};

// Every channel of b bits that is set up from words of its own takes those of the colours, stretched: from end to end
// where a colour goes from end to end.
constexpr std::int64_t stretched_colour(const Config& config, int colour, int bits) {
  return colour * (((std::int64_t(1) << bits) - 1) / ((1 << config.colour_bits) - 1));
}

// A place among texels, in units of 2^−kWeightBits, modulo the sides.
struct ProbedPlace {
  std::uint64_t u, v;
};

// A channel of four texels, even columns first, with the weights of the odd column and the odd row in 2^−kWeightBits.
struct TexelSample {
  std::uint32_t lit;
  std::array<std::uint32_t, 4> texel;
  int odd_column, odd_row;
};
struct ProbedTexel {
  std::uint32_t filtered;  // units of 2^−kFilteredFraction; without a filter the texel
  std::uint32_t colour;
};

struct ProbedInverse {
  double error = 0;  // largest |y·m − 1|
  std::int64_t q = 0;
  std::uint64_t compared = 0;
};

class KernelProbe {
 public:
  virtual ~KernelProbe() = default;
  virtual void set_frame(int width, int height) = 0;
  // The registers and tables of what the configuration has.
  virtual void load(const LightingFrame& lighting) = 0;
  virtual void load(const TextureFrame& texture) = 0;

  // The reciprocal is that of hls/setup/reciprocal.hpp called apart: not every configuration has it in a stream.
  virtual ProbedSetup setup(const ref::SnappedTriangle& triangle) = 0;
  // The covered pixels of the triangle that setup() was given last, in the order and as often as they are sent.
  virtual std::vector<ProbedPixel> pixels() = 0;

  // In the place of the words that setup() made of the colours: its normals, which are lit; its coordinates; its places
  // in the key frames.
  virtual void give(const RawNormals& normals) = 0;
  virtual void give(const RawCoordinates& coordinates) = 0;
  virtual void give(const RawMotionVectors& vectors) = 0;
  // Where a pixel of the triangle lies in its texture, as if that were `texture`.
  virtual ProbedPlace place(const RawTexture& texture, int x, int y) = 0;
  virtual RawMotion motion(int x, int y) = 0;
  // The normal of a pixel of the triangle, with Phong shading.
  virtual std::array<int, 3> normal(int x, int y) = 0;
  // The colour of a pixel of the triangle before texture, and as the picture has it.
  virtual std::array<std::uint32_t, 3> lit(int x, int y) = 0;
  virtual std::array<std::uint32_t, 3> shown(int x, int y) = 0;

  // Units that have no triangle.
  virtual ProbedTexel textured(const TexelSample& sample) = 0;
  // reciprocal_lookup of every field, with all and with none of the bits that are cut.
  virtual ProbedInverse worst_inverse() = 0;
};

// With the lanes of the configuration.
std::unique_ptr<KernelProbe> make_kernel_probe(const Config& config);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_BOUNDS_BOUNDS_PROBE_HPP_
