// SPDX-License-Identifier: Apache-2.0
// What the triangles of a frame take of triangle_setup, by the words that go in and come out.
#ifndef HALFSPACE_TB_REPORT_SETUP_WORK_HPP_
#define HALFSPACE_TB_REPORT_SETUP_WORK_HPP_

#include <cstddef>
#include <cstdint>

#include "tb/harness/vectors.hpp"

namespace halfspace::tb {

struct SetupWork {
  std::uint64_t cycles = 0;  // at least: 3 where the box holds no pixel centre, 7 of another that comes out empty
  std::uint64_t culled = 0;  // that come out empty with a pixel centre in their box, and an area
};

// Of a frame, whose words of `setup` are those from `from` on; a triangle that is not empty takes `interval` cycles.
SetupWork setup_work(const Vectors& vectors, const Words& setup, std::size_t from, std::size_t frame,
                     std::uint64_t interval);

}  // namespace halfspace::tb

#endif  // HALFSPACE_TB_REPORT_SETUP_WORK_HPP_
