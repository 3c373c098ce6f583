// SPDX-License-Identifier: Apache-2.0
// What the four architectures of index rendering take: lighting, buffers, bandwidth, by the hardware levels of the
// paper.
#ifndef HALFSPACE_STUDY_PAPERS_INDEX_RENDERING_HPP_
#define HALFSPACE_STUDY_PAPERS_INDEX_RENDERING_HPP_

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "model/pipeline/memories.hpp"
#include "ref/raster/architecture.hpp"

namespace halfspace::model {

// A level of hardware as the paper has them; `config` names the configuration of which it takes the number formats.
struct HardwareLevel {
  const char* config;
  int triangles;                           // a frame at most: 2 M, 480 k, 96 k a second, to the next power of two
  int frames;                              // a second
  int normal_bits;                         // fraction bits of a component of a normal, for Phong shading
  std::vector<std::pair<int, int>> sizes;  // the paper names 800x600, twice, 640x480 and 320x200; the others are ours
};
const std::vector<HardwareLevel>& hardware_levels();  // high first

// What a pixel of the wide buffer of deferred shading holds.
enum class WidePixel {
  kPlanes,        // the parameters of its triangle, as TdbS has them: the paper's direct method
  kInterpolated,  // what they come to at the pixel: a colour; a normal and a material with Phong shading
};

// Bits of an entry.
BufferBits buffer_bits(const HardwareLevel&, ref::ShadingMode, WidePixel);

struct BufferBytes {
  double depth = 0, frame = 0, pixel = 0, index = 0, visibility = 0, shading = 0;
  double total() const { return depth + frame + pixel + index + visibility + shading; }
};
// Of the memories of a frame of `width` x `height` with all the triangles that the level takes.
BufferBytes buffer_sizes(const HardwareLevel&, int width, int height, ref::Architecture, ref::ShadingMode, WidePixel);
// Read and written a frame.
BufferBytes buffer_traffic(const ref::BufferUses&, const BufferBits&);
// Accesses of the worst frame: all triangles that the level takes are visible, as the paper says, each with
// kTrianglePixels fragments, all of which pass, which are ours: it prints neither. Each pixel reads TdbS.
constexpr int kTrianglePixels = 50;
ref::BufferUses largest_uses(const HardwareLevel&, int width, int height, ref::Architecture);

// A frame by each architecture.
struct ArchitectureRates {
  ref::Rates rates;
  ref::BufferUses uses;
};
using FourRates = std::array<ArchitectureRates, 4>;  // in the order of kArchitectures

// Draws the scene in `config`'s positions and depth, with the textures that it has, if any: nearest texels, by planes
// of u and v. Throws ref::Error when two of the pictures differ.
FourRates measure_architectures(const ref::Scene&, const std::string& config, int width, int height, ref::ShadingMode);

// With its back faces culled, or all of them drawn.
ref::Scene culled(ref::Scene, bool cull);

// The bits of beta's wide pixel with which gamma and beta move the same number of bytes: with fewer gamma moves more.
double even_pixel_bits(const BufferBytes& beta, const BufferBytes& gamma, const ref::BufferUse& pixel);

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_PAPERS_INDEX_RENDERING_HPP_
