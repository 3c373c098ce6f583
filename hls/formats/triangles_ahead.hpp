// SPDX-License-Identifier: Apache-2.0
// How many triangles geometry may send before it takes a `visible`.
#ifndef HALFSPACE_HLS_FORMATS_TRIANGLES_AHEAD_HPP_
#define HALFSPACE_HLS_FORMATS_TRIANGLES_AHEAD_HPP_

namespace halfspace {

// So many triangles may wait for their `visible` with any formats: setups and, deferred, attributes of them all fit.
constexpr int kTrianglesAhead = 512;

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_TRIANGLES_AHEAD_HPP_
