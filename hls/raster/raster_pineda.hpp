// SPDX-License-Identifier: Apache-2.0
// The Pineda edge-function rasterizer: the stamps of a triangle that hold a covered pixel, each once; and for a Z-test
// that needs it (type γ) its depth plane before them.
//
// A stamp is *near* when each edge function is >= 0 at one of its pixel centres at least; every covered stamp is near.
// In a row of stamps the near ones are consecutive. The walk takes the rows from the top: it finds a near stamp of the
// row, goes right to the last one, then left from where it began. On the way it keeps the first stamp whose neighbour
// below is near: the next row begins there. Without one it searches from where it stands, in the direction in
// which the edges that fail increase; edges that disagree prove the row empty.
// One stamp a cycle; `visits` hears how many a triangle took. An adjacent stamp is entered only when it is near, so
// that a cycle without a covered pixel is the price of a corner that only single edges reach, or of a search.
#ifndef HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_
#define HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

// Where the walk stands: edge functions and depth plane at the first pixel of a stamp.
template <class F>
struct WalkPosition {
  int x, y;  // in stamps
  typename F::EdgeStep e[3];
  typename F::DepthPlane depth;
};

// The steps of a triangle, constant while it is walked.
template <class F>
struct WalkSteps {
  typename F::EdgeStep e_x[3], e_y[3];        // to the next stamp right, below
  typename F::EdgeStep reach[3];              // to the pixel of a stamp where the edge function is largest
  typename F::EdgeStep lane_e[3][F::kLanes];  // to each pixel of a stamp
  typename F::DepthPlane depth_x, depth_y, lane_depth[F::kLanes];
};

template <class F>
WalkSteps<F> walk_steps(const Setup<F>& in) {
  WalkSteps<F> steps;
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    const std::int64_t dx = raw(in.e_dx[i]), dy = raw(in.e_dy[i]);
    using E = typename F::EdgeStep;
    steps.e_x[i] = from_raw<E>(dx * F::kLanesX);
    steps.e_y[i] = from_raw<E>(dy * F::kLanesY);
    steps.reach[i] = from_raw<E>((dx > 0 ? dx : 0) * (F::kLanesX - 1) + (dy > 0 ? dy : 0) * (F::kLanesY - 1));
  EdgeLanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      steps.lane_e[i][l] = from_raw<E>(dx * (l % F::kLanesX) + dy * (l / F::kLanesX));
    }
  }
  if (!F::kHasDepth) return steps;
  using Z = typename F::DepthPlane;
  const std::int64_t dx = raw(in.depth_dx), dy = raw(in.depth_dy);
  steps.depth_x = from_raw<Z>(dx * F::kLanesX);
  steps.depth_y = from_raw<Z>(dy * F::kLanesY);
DepthLanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    steps.lane_depth[l] = from_raw<Z>(dx * (l % F::kLanesX) + dy * (l / F::kLanesX));
  }
  return steps;
}

// `from` moved by one stamp: step_x, step_y in {−1, 0, 1}.
template <class F>
WalkPosition<F> walk(const WalkPosition<F>& from, const WalkSteps<F>& steps, int step_x, int step_y) {
  WalkPosition<F> to;
  to.x = from.x + step_x;
  to.y = from.y + step_y;
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    using E = typename F::EdgeStep;
    to.e[i] = from_raw<E>(raw(from.e[i]) +
                          (step_x < 0   ? -raw(steps.e_x[i])
                           : step_x > 0 ? raw(steps.e_x[i])
                                        : 0) +
                          (step_y > 0 ? raw(steps.e_y[i]) : 0));
  }
  to.depth = from.depth;
  if (!F::kHasDepth) return to;
  using Z = typename F::DepthPlane;
  to.depth = from_raw<Z>(raw(from.depth) +
                         (step_x < 0   ? std::uint64_t(0) - raw(steps.depth_x)
                          : step_x > 0 ? std::uint64_t(raw(steps.depth_x))
                                       : 0) +
                         (step_y > 0 ? raw(steps.depth_y) : 0));
  return to;
}

template <class F>
bool edge_near(const WalkPosition<F>& at, const WalkSteps<F>& steps, int i) {
  return raw(from_raw<typename F::EdgeStep>(raw(at.e[i]) + raw(steps.reach[i]))) >= 0;
}
template <class F>
bool near(const WalkPosition<F>& at, const WalkSteps<F>& steps) {
  return edge_near(at, steps, 0) && edge_near(at, steps, 1) && edge_near(at, steps, 2);
}

// The coverage and depths of a stamp. Returns whether a pixel is covered.
template <class F>
bool cover(const Frame<F>& frame, const WalkPosition<F>& at, const WalkSteps<F>& steps, Stamp<F>& stamp) {
  const int columns = int(raw(frame.width)) - at.x * F::kLanesX;  // of the frame from here on
  const int rows = int(raw(frame.height)) - at.y * F::kLanesY;
  stamp.x = from_raw<typename F::X>(at.x);
  stamp.y = from_raw<typename F::Y>(at.y);
  using E = typename F::EdgeStep;
  unsigned any = 0;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const E e0 = at.e[0] + steps.lane_e[0][l];
    const E e1 = at.e[1] + steps.lane_e[1][l];
    const E e2 = at.e[2] + steps.lane_e[2][l];
    const unsigned inside = unsigned((raw(e0) | raw(e1) | raw(e2)) >= 0) & unsigned(l % F::kLanesX < columns) &
                            unsigned(l / F::kLanesX < rows);
    stamp.mask[l] = from_raw<Bit>(inside);
    any |= inside;
  }
Depths:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    typename F::DepthPlane depth = at.depth;
    if (F::kHasDepth) depth = at.depth + steps.lane_depth[l];
    stamp.depth[l] = depth;
  }
  return any != 0;
}

template <class F>
void raster_pineda(const Frame<F>& frame, Stream<Setup<F>>& setup, Stream<Stamp<F>>& stamp,
                   Stream<TriangleDepth<F>>& depth_plane, Probe<int>& visits) {
  const Setup<F> in = setup.read();
  if (F::kTestsPlanes) {
    TriangleDepth<F> plane;
    plane.index = in.index;
    plane.x = in.x_start;
    plane.y = in.y_min;
    plane.depth = in.depth;
    plane.depth_dx = in.depth_dx;
    plane.depth_dy = in.depth_dy;
    depth_plane.write(plane);
  }
  const WalkSteps<F> steps = walk_steps(in);
  const int x_min = int(raw(in.x_min)), x_max = int(raw(in.x_max)), y_max = int(raw(in.y_max));

  WalkPosition<F> at, left, below;
  at.x = int(raw(in.x_start));
  at.y = int(raw(in.y_min));
  at.depth = in.depth;
Start:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    at.e[i] = in.e[i];
  }
  left = below = at;
  bool left_near = false, below_near = false;

  enum Mode { kSearch, kSearchRight, kSearchLeft, kRight, kLeft };
  Mode mode = kSearch;

  // The stamp found last waits for the next one, or for the end, which makes it the last of the triangle.
  Stamp<F> found{};
  found.index = in.index;
  bool pending = false;

  const int max_cycles = 2 * F::kStamps + F::kStampsX + F::kStampsY;  // no row is entered or searched twice
  int cycle = 0;
  bool done = raw(in.empty) != 0;
Walk:
  for (; cycle < max_cycles && !done; ++cycle) {
    HS_PIPELINE(1)
    const bool near_0 = edge_near(at, steps, 0), near_1 = edge_near(at, steps, 1), near_2 = edge_near(at, steps, 2);
    bool row_done = false;
    if (near_0 && near_1 && near_2) {
      Stamp<F> covered;
      covered.last = from_raw<Bit>(0);
      covered.triangle_last = from_raw<Bit>(0);
      covered.index = in.index;
      if (cover(frame, at, steps, covered)) {
        if (pending) stamp.write(found);
        found = covered;
        pending = true;
      }
      const WalkPosition<F> right_of = walk(at, steps, 1, 0);
      const WalkPosition<F> left_of = walk(at, steps, -1, 0);
      const bool can_go_left = at.x > x_min && near(left_of, steps);
      if (!below_near && at.y < y_max) {
        below = walk(at, steps, 0, 1);
        below_near = near(below, steps);
      }
      if (mode != kRight && mode != kLeft) {
        left = left_of;
        left_near = can_go_left;
      }
      if (mode != kLeft && at.x < x_max && near(right_of, steps)) {
        at = right_of;
        mode = kRight;
      } else if (mode != kLeft && left_near) {
        at = left;
        mode = kLeft;
      } else if (mode == kLeft && can_go_left) {
        at = left_of;
      } else {
        row_done = true;
      }
    } else {
      const bool want_right =
          (!near_0 && raw(in.e_dx[0]) > 0) || (!near_1 && raw(in.e_dx[1]) > 0) || (!near_2 && raw(in.e_dx[2]) > 0);
      const bool bar_right =
          (!near_0 && raw(in.e_dx[0]) <= 0) || (!near_1 && raw(in.e_dx[1]) <= 0) || (!near_2 && raw(in.e_dx[2]) <= 0);
      const bool bar_left = want_right || (!near_0 && raw(in.e_dx[0]) == 0) || (!near_1 && raw(in.e_dx[1]) == 0) ||
                            (!near_2 && raw(in.e_dx[2]) == 0);
      if (!bar_right && mode != kSearchLeft && at.x < x_max) {
        at = walk(at, steps, 1, 0);
        mode = kSearchRight;
      } else if (!bar_left && mode != kSearchRight && at.x > x_min) {
        at = walk(at, steps, -1, 0);
        mode = kSearchLeft;
      } else {
        row_done = true;
      }
    }
    if (row_done) {
      done = at.y == y_max;
      at = below_near ? below : walk(at, steps, 0, 1);
      below_near = false;
      mode = kSearch;
    }
  }
  found.triangle_last = from_raw<Bit>(1);
  found.last = in.last;
  stamp.write(found);
  visits.write(cycle);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_
