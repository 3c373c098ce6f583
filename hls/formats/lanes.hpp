// SPDX-License-Identifier: Apache-2.0
// What units do that take the triangles of a stamp one after the other: the lanes of the next triangle, and its plane
// in these lanes.
#ifndef HALFSPACE_HLS_FORMATS_LANES_HPP_
#define HALFSPACE_HLS_FORMATS_LANES_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// The triangle of the first lane that waits: returns its index, puts its lanes that wait into `group` and takes them
// out of `waits`. 0 if no lane waits, as none of index 0 does.
template <class F>
int next_group(const typename F::Index (&index)[F::kLanes], Bit (&waits)[F::kLanes], Bit (&group)[F::kLanes]) {
  int first = F::kLanes;
Pick:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const int lane = is_set(waits[l]) ? l : F::kLanes;
    first = lane < first ? lane : first;
  }
  if (first == F::kLanes) return 0;
  const typename F::Index triangle = index[first];
Match:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const bool matches = index[l] == triangle;
    group[l] = from_raw<Bit>(is_set(waits[l]) & matches);
    waits[l] = from_raw<Bit>(is_set(waits[l]) & !matches);
  }
  return int(raw(triangle));
}

template <class F>
bool any_waits(const Bit (&waits)[F::kLanes]) {
  bool any = false;
Any:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    any |= is_set(waits[l]);
  }
  return any;
}

// The value of a plane at pixel (x, y), modulo its width.
template <class F, class Plane, class Gradient>
Plane plane_at(const Plane& origin, const Gradient& dx, const Gradient& dy, int x, int y) {
  const Plane along_x = dx * from_raw<typename F::X>(x);
  const Plane along_y = dy * from_raw<typename F::Y>(y);
  const Plane start_x = origin + along_x;
  return start_x + along_y;
}

// The values of a plane, rounded down, in the lanes of `group`, from pixel (x, y) on. Modulo the width of Plane.
template <class F, class Plane, class Gradient, class Value>
void plane_lanes(const Plane& origin, const Gradient& dx, const Gradient& dy, int x, int y,
                 const Bit (&group)[F::kLanes], Value (&value)[F::kLanes]) {
  const Plane start = plane_at<F>(origin, dx, dy, x, y);
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const Value rounded = stepped(start, dx, l & (F::kLanesX - 1), dy, l >> F::kLog2LanesX);
    value[l] = select(is_set(group[l]), rounded, value[l]);
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_FORMATS_LANES_HPP_
