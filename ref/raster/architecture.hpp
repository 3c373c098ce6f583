// SPDX-License-Identifier: Apache-2.0
// The four architectures that index rendering compares: alpha, traditional; beta, deferred shading with a wide pixel
// buffer; gamma, index rendering without a Z-buffer, the depth of what is stored computed again from TdbV; delta, index
// rendering with a Z-buffer. They draw the same picture, and differ in what they light, read, write and store.
#ifndef HALFSPACE_REF_RASTER_ARCHITECTURE_HPP_
#define HALFSPACE_REF_RASTER_ARCHITECTURE_HPP_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "ref/geometry/snap.hpp"
#include "ref/geometry/surface.hpp"
#include "ref/raster/index_pool.hpp"

namespace halfspace::ref {

enum class Architecture { kAlpha, kBeta, kGamma, kDelta };
constexpr Architecture kArchitectures[] = {Architecture::kAlpha, Architecture::kBeta, Architecture::kGamma,
                                           Architecture::kDelta};
const char* name_of(Architecture);  // "alpha", …
constexpr bool is_index_rendering(Architecture a) { return a == Architecture::kGamma || a == Architecture::kDelta; }

// The data rates of a frame, and what they cause. Triangles that cover no pixel centre count as triangles.
struct Rates {
  std::uint64_t triangles = 0, reduced_triangles = 0;  // handed over; with a fragment that passed the test
  std::uint64_t culled = 0;  // with area and a pixel centre in their box, dropped by the sign of their area
  std::uint64_t fragments = 0, reduced_fragments = 0;  // covered; that passed
  std::uint64_t visible_pixels = 0, pixels = 0;        // that show a triangle in the end; of the frame
  std::uint64_t runs = 0;                              // of visible pixels of one triangle side by side in a row
  std::uint64_t lightings = 0;                         // of a vertex, a triangle or a pixel, by the shading
  std::uint64_t texture_fetches = 0;                   // texels
  std::uint64_t largest_index = 0;  // entries of TdbV and TdbS that are needed; 0 without index rendering
};

// Accesses of a buffer, in entries.
struct BufferUse {
  std::uint64_t entries = 0, read = 0, written = 0;
};

struct BufferUses {
  BufferUse depth;  // Z-buffer; cleared once a frame by alpha and beta: with an index, 0 says that nothing is there
  BufferUse frame;  // colours
  BufferUse pixel;  // the wide one of beta: what shading needs
  BufferUse index;  // I-buffer
  BufferUse visibility;  // TdbV
  BufferUse shading;     // TdbS
  BufferUse object;      // the objects of triangles, where pixels know theirs
};

// How a circuit looks at TdbV and TdbS. Without lanes, pixel by pixel: TdbV is read for each fragment over a triangle,
// TdbS for each run of pixels of one triangle in a row. With a stamp of lanes_x x lanes_y, each different entry is read
// once a stamp.
struct Circuit {
  int lanes_x = 0, lanes_y = 0;
  bool stores_invisible =
      false;  // TdbS takes each triangle that has area and a pixel centre of the frame in its box, seen or not
};

struct Drawing {
  std::vector<std::uint32_t> triangle;              // that each pixel shows, from 1 on; 0: background
  std::vector<std::uint32_t> depth;                 // of it
  std::vector<std::array<std::uint8_t, 4>> colour;  // r, g, b, 255
  std::vector<bool> visible;                        // triangle k at [k - 1]: has a fragment passed the test?
  Rates rates;
  BufferUses buffers;
};

// Draws `list`, of which the surface knows the shading. With `deferred_lighting` index rendering lights visible
// triangles alone. Throws Error when the indices are used up.
Drawing draw(const SnappedList& list, Surface& surface, Architecture, bool deferred_lighting = true,
             const IndexReuse& = {}, const Circuit& = {});

}  // namespace halfspace::ref

#endif  // HALFSPACE_REF_RASTER_ARCHITECTURE_HPP_
