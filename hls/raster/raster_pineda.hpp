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

// What the edges that fail at a stamp say of the way to a near one in its row.
template <class F>
struct SearchWay {
  bool right, left;  // a near stamp may lie there
};
template <class F>
SearchWay<F> search_way(const Setup<F>& in, const bool (&edge_near)[3]) {
  bool want_right = false, bar_right = false, level = false;
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    const auto dx = raw(in.e_dx[i]);
    want_right = want_right || (!edge_near[i] && dx > 0);
    bar_right = bar_right || (!edge_near[i] && dx <= 0);
    level = level || (!edge_near[i] && dx == 0);
  }
  SearchWay<F> way;
  way.right = !bar_right;
  way.left = !want_right && !level;
  return way;
}

// The process: take() a triangle, visit() while walks(), then finish(). Each is a step of one cycle that sends a stamp
// at most.
template <class F>
class RasterPineda {
 public:
  HS_INLINE void take(const Setup<F>& in) {
    in_ = in;
    steps_ = walk_steps(in);
    at_.x = int(raw(in.x_start));
    at_.y = int(raw(in.y_min));
    at_.depth = in.depth;
  Start:
    for (int i = 0; i < 3; ++i) {
      HS_UNROLL
      at_.e[i] = in.e[i];
    }
    left_ = below_ = at_;
    left_near_ = below_near_ = pending_ = false;
    mode_ = kSearch;
    found_ = Stamp<F>{};
    found_.index = in.index;
    walks_ = raw(in.empty) == 0;
  }

  // Of the triangle, for a Z-test that needs it.
  TriangleDepth<F> depth_plane() const {
    TriangleDepth<F> plane;
    plane.index = in_.index;
    plane.x = in_.x_start;
    plane.y = in_.y_min;
    plane.depth = in_.depth;
    plane.depth_dx = in_.depth_dx;
    plane.depth_dy = in_.depth_dy;
    return plane;
  }

  bool walks() const { return walks_; }
  // Whether the triangle is the frame's last.
  bool is_last() const { return is_set(in_.last); }

  // Visits a stamp. Returns whether `out` is to be sent: the stamp found last waits for the next one, or for finish().
  HS_INLINE bool visit(const Frame<F>& frame, Stamp<F>& out) {
    const bool near[3] = {edge_near(at_, steps_, 0), edge_near(at_, steps_, 1), edge_near(at_, steps_, 2)};
    bool row_done = false, sends = false;
    if (near[0] && near[1] && near[2]) {
      Stamp<F> covered;
      covered.last = from_raw<Bit>(0);
      covered.triangle_last = from_raw<Bit>(0);
      covered.index = in_.index;
      if (cover(frame, at_, steps_, covered)) {
        sends = pending_;
        out = found_;
        found_ = covered;
        pending_ = true;
      }
      row_done = !walk_on();
    } else {
      row_done = !search_on(near);
    }
    if (row_done) {
      walks_ = at_.y != int(raw(in_.y_max));
      at_ = below_near_ ? below_ : walk(at_, steps_, 0, 1);
      below_near_ = false;
      mode_ = kSearch;
    }
    return sends;
  }

  // The last stamp of the triangle, with an empty mask if it has none.
  HS_INLINE void finish(Stamp<F>& out) const {
    out = found_;
    out.triangle_last = from_raw<Bit>(1);
    out.last = in_.last;
  }

 private:
  enum Mode { kSearch, kSearchRight, kSearchLeft, kRight, kLeft };

  // From a near stamp to the next one of its row. Returns whether there is one.
  HS_INLINE bool walk_on() {
    const WalkPosition<F> right_of = walk(at_, steps_, 1, 0);
    const WalkPosition<F> left_of = walk(at_, steps_, -1, 0);
    const bool can_go_left = at_.x > int(raw(in_.x_min)) && near(left_of, steps_);
    if (!below_near_ && at_.y < int(raw(in_.y_max))) {
      below_ = walk(at_, steps_, 0, 1);
      below_near_ = near(below_, steps_);
    }
    if (mode_ != kRight && mode_ != kLeft) {
      left_ = left_of;
      left_near_ = can_go_left;
    }
    if (mode_ != kLeft && at_.x < int(raw(in_.x_max)) && near(right_of, steps_)) {
      at_ = right_of;
      mode_ = kRight;
    } else if (mode_ != kLeft && left_near_) {
      at_ = left_;
      mode_ = kLeft;
    } else if (mode_ == kLeft && can_go_left) {
      at_ = left_of;
    } else {
      return false;
    }
    return true;
  }

  // From a stamp that is not near towards one. Returns whether the row may still have one.
  HS_INLINE bool search_on(const bool (&near)[3]) {
    const SearchWay<F> way = search_way(in_, near);
    if (way.right && mode_ != kSearchLeft && at_.x < int(raw(in_.x_max))) {
      at_ = walk(at_, steps_, 1, 0);
      mode_ = kSearchRight;
    } else if (way.left && mode_ != kSearchRight && at_.x > int(raw(in_.x_min))) {
      at_ = walk(at_, steps_, -1, 0);
      mode_ = kSearchLeft;
    } else {
      return false;
    }
    return true;
  }

  Setup<F> in_;
  WalkSteps<F> steps_;
  WalkPosition<F> at_, left_, below_;
  bool left_near_, below_near_;
  Mode mode_;
  Stamp<F> found_;
  bool pending_, walks_;
};

// Walks triangles, each step of a cycle: taking one, visiting a stamp, or its end.
template <Until kUntil, class F>
HS_INLINE inline bool raster_pineda_steps(const Frame<F>& frame, Stream<Setup<F>>& setup, Stream<Stamp<F>>& stamp,
                                          Stream<TriangleDepth<F>>& depth_plane, Probe<int>& visits) {
  RasterPineda<F> unit;
  int count = 0;
  bool has_triangle = false, done = false;
Steps:
  while (!done) {
    HS_PIPELINE(1)
    if (!has_triangle) {
      unit.take(setup.read());
      if (F::kTestsPlanes) depth_plane.write(unit.depth_plane());
      has_triangle = true;
      count = 0;
    } else {
      Stamp<F> out;
      bool sends = true;
      if (unit.walks()) {
        sends = unit.visit(frame, out);
        ++count;
      } else {
        unit.finish(out);
        visits.write(count);
        has_triangle = false;
        done = kUntil == Until::kTriangleEnds || unit.is_last();
      }
      if (sends) stamp.write(out);
    }
  }
  return unit.is_last();
}

template <class F>
bool raster_pineda(const Frame<F>& frame, Stream<Setup<F>>& setup, Stream<Stamp<F>>& stamp,
                   Stream<TriangleDepth<F>>& depth_plane, Probe<int>& visits) {
  return raster_pineda_steps<Until::kTriangleEnds>(frame, setup, stamp, depth_plane, visits);
}
template <class F>
void raster_pineda_frame(const Frame<F>& frame, Stream<Setup<F>>& setup, Stream<Stamp<F>>& stamp,
                         Stream<TriangleDepth<F>>& depth_plane, Probe<int>& visits) {
  raster_pineda_steps<Until::kFrameEnds>(frame, setup, stamp, depth_plane, visits);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_
