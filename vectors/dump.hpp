// SPDX-License-Identifier: Apache-2.0
// Dumps of a rendered frame, and what differs between two dumps.
//
// A dump is a folder: index.u32 (0 = background, k = k-th triangle), depth.u32, colour.rgba8, little endian, row 0 on
// top, and triangles.tri, what was rasterized, exactly as snapped.
#ifndef HALFSPACE_VECTORS_DUMP_HPP_
#define HALFSPACE_VECTORS_DUMP_HPP_

#include <cstdint>
#include <string>
#include <vector>

#include "ref/geometry/snap.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::model {

void write_dump(const std::string& folder, const ref::SnappedList& scene, const ref::Frame& frame);

// A buffer of two dumps, held against each other.
struct Difference {
  std::string part;
  std::uint64_t values = 0;  // compared
  std::uint64_t different = 0;
  std::int64_t largest = 0;  // of |a − b|, LSB
  std::string first;         // where, and both values; empty when equal
};

// Whether a folder is one.
bool is_dump(const std::string& folder);
// Two dumps of one size. Throws ref::Error when they are not.
std::vector<Difference> compare_dumps(const std::string& a, const std::string& b);

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_DUMP_HPP_
