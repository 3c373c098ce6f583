// SPDX-License-Identifier: Apache-2.0
// The data rates of a frame, counted in the words that the RTL sent.
#ifndef HALFSPACE_TB_REPORT_RATES_HPP_
#define HALFSPACE_TB_REPORT_RATES_HPP_

#include <cstdint>
#include <map>
#include <string>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

struct Rates {
  std::uint64_t triangles = 0, reduced_triangles = 0;  // done; with a fragment that passed the Z-test
  std::uint64_t culled = 0;                            // see SetupWork
  std::uint64_t fragments = 0, reduced_fragments = 0;  // covered; that passed
  std::uint64_t visible_pixels = 0;                    // that show a triangle
  bool lights = false;
  std::uint64_t lightings = 0;  // of a vertex, of a triangle if it has one colour, or of a pixel
  bool textures = false;
  std::uint64_t texture_fetches = 0;  // texels
};

// The streams that tell them, and what is read and written.
extern const char* const kCountedStreams[9];
// Of the words received, by stream; one that is not there counts nothing. A textured pixel takes `texels`.
Rates count_rates(const Vectors& vectors, const std::map<std::string, Words>& received, int texels);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_RATES_HPP_
