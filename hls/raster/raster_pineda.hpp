// SPDX-License-Identifier: Apache-2.0
// The Pineda edge-function rasterizer: the stamps of a triangle that hold a covered pixel, each once; and for a Z-test
// that needs it (type γ) its depth plane before them.
//
// A stamp is *near* when each edge function is >= 0 at one of its pixel centres at least; every covered stamp is near.
// In a row of stamps the near ones are consecutive. The walk takes the rows from the top: it finds a near stamp of the
// row, goes right to the last one, then left from where it began. On the way it keeps the first stamp whose neighbour
// below is near: the next row begins there. Without one it searches from where it stands, in the direction in
// which the edges that fail increase; edges that disagree prove the row empty.
// `visits` hears how many a triangle took. An adjacent stamp is entered only when it is near, so
// that a cycle without a covered pixel is the price of a corner that only single edges reach, or of a search.
//
// Interval: a cycle a visited stamp, and two a triangle, to take it and to end it, which the RTL does meanwhile.
#ifndef HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_
#define HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_

#include "hls/formats/records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// An edge function modulo the width of F::EdgeStep: it is negative where the top bit is set. A tool sees how wide a
// word without a sign is, not one with a sign in a longer carrier.
template <class F>
using EdgeWord = typename F::EdgeStep::Unsigned;
template <class F>
HS_INLINE inline bool is_outside(const EdgeWord<F>& e) {
  return is_negative(typename F::EdgeStep(e));
}

// Where the walk stands.
template <class F>
struct WalkPosition {
  typename F::X x;  // in stamps
  typename F::Y y;
  EdgeWord<F> e[3];  // at the pixel of the stamp where it is largest: the stamp is near when none is outside
  typename F::DepthPlane depth;  // at its first pixel
};

// The steps of a triangle, constant while it is walked.
template <class F>
struct WalkSteps {
  EdgeWord<F> e_x[3], e_y[3];        // to the next stamp right, below
  EdgeWord<F> lane_e[3][F::kLanes];  // to each pixel of a stamp, from the one where the edge function is largest
  typename F::DepthPlane depth_x, depth_y, lane_depth[F::kLanes];  // from the first one
  bool rises_right[3], rises_left[3];                              // edge functions
};

template <class F>
HS_INLINE inline WalkSteps<F> walk_steps(const Setup<F>& in) {
  using E = typename F::EdgeStep;
  WalkSteps<F> steps;
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    const typename F::Delta dx = in.e_dx[i], dy = in.e_dy[i], level = from_raw<typename F::Delta>(0);
    const E reach = multiple(select(is_negative(dx), level, dx), F::kLanesX - 1) +
                    multiple(select(is_negative(dy), level, dy), F::kLanesY - 1);
    steps.e_x[i] = multiple(dx, F::kLanesX);
    steps.e_y[i] = multiple(dy, F::kLanesY);
    steps.rises_left[i] = is_negative(dx);
    steps.rises_right[i] = !is_negative(dx) && !is_zero(dx);
  EdgeLanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      const E offset = multiple(dx, l % F::kLanesX) + multiple(dy, l / F::kLanesX);
      steps.lane_e[i][l] = offset - reach;
    }
  }
  if (!F::kHasDepth) return steps;
  steps.depth_x = multiple(in.depth_dx, F::kLanesX);
  steps.depth_y = multiple(in.depth_dy, F::kLanesY);
DepthLanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    steps.lane_depth[l] = multiple(in.depth_dx, l % F::kLanesX) + multiple(in.depth_dy, l / F::kLanesX);
  }
  return steps;
}

template <class F>
HS_INLINE inline WalkPosition<F> right_of(const WalkPosition<F>& at, const WalkSteps<F>& steps) {
  WalkPosition<F> to = at;
  to.x = at.x + from_raw<typename F::X>(1);
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    to.e[i] = at.e[i] + steps.e_x[i];
  }
  if (F::kHasDepth) to.depth = at.depth + steps.depth_x;
  return to;
}
template <class F>
HS_INLINE inline WalkPosition<F> left_of(const WalkPosition<F>& at, const WalkSteps<F>& steps) {
  WalkPosition<F> to = at;
  to.x = at.x - from_raw<typename F::X>(1);
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    to.e[i] = at.e[i] - steps.e_x[i];
  }
  if (F::kHasDepth) to.depth = at.depth - steps.depth_x;
  return to;
}
template <class F>
HS_INLINE inline WalkPosition<F> below(const WalkPosition<F>& at, const WalkSteps<F>& steps) {
  WalkPosition<F> to = at;
  to.y = at.y + from_raw<typename F::Y>(1);
Edges:
  for (int i = 0; i < 3; ++i) {
    HS_UNROLL
    to.e[i] = at.e[i] + steps.e_y[i];
  }
  if (F::kHasDepth) to.depth = at.depth + steps.depth_y;
  return to;
}

template <class F>
HS_INLINE inline bool is_near(const WalkPosition<F>& at) {
  return !is_outside<F>(at.e[0]) && !is_outside<F>(at.e[1]) && !is_outside<F>(at.e[2]);
}

// The coverage and depths of a stamp. Returns whether a pixel is covered.
template <class F>
HS_INLINE inline bool cover(const Frame<F>& frame, const WalkPosition<F>& at, const WalkSteps<F>& steps,
                            Stamp<F>& stamp) {
  using E = typename F::EdgeStep;
  const typename F::X columns = frame.width - shift_left(at.x, F::kLog2LanesX);  // of the frame from here on
  const typename F::Y rows = frame.height - shift_left(at.y, F::kLog2LanesY);
  const int last_column = int(raw(columns)), last_row = int(raw(rows));
  stamp.x = at.x;
  stamp.y = at.y;
  unsigned any = 0;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const EdgeWord<F> e0 = at.e[0] + steps.lane_e[0][l];
    const EdgeWord<F> e1 = at.e[1] + steps.lane_e[1][l];
    const EdgeWord<F> e2 = at.e[2] + steps.lane_e[2][l];
    const unsigned inside = unsigned((raw(E(e0)) | raw(E(e1)) | raw(E(e2))) >= 0) &
                            unsigned(l % F::kLanesX < last_column) & unsigned(l / F::kLanesX < last_row);
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

// The process: take() a triangle, visit() while walks(), then finish(). Each is a step of one cycle that sends a stamp
// at most.
template <class F>
class RasterPineda {
 public:
  HS_INLINE void take(const Setup<F>& in) {
    in_ = in;
    steps_ = walk_steps(in);
    at_.x = in.x_start;
    at_.y = in.y_min;
    at_.depth = in.depth;
  Start:
    for (int i = 0; i < 3; ++i) {
      HS_UNROLL
      at_.e[i] = EdgeWord<F>(in.e[i]) - steps_.lane_e[i][0];
    }
    left_near_ = below_near_ = pending_ = false;
    mode_ = kSearch;
    found_ = Stamp<F>{};
    found_.index = in.index;
    walks_ = !is_set(in.empty);
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
  // All that is decided on is the sign of a sum.
  HS_INLINE bool visit(const Frame<F>& frame, Stamp<F>& out) {
    const bool can_go_right = at_.x != in_.x_max, can_go_left = at_.x != in_.x_min, has_row_below = at_.y != in_.y_max;
    bool sends = false;
    Mode next = kSearch;  // of the next row
    if (is_near(at_)) {
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
      const bool left_near = can_go_left && is_near(left_of(at_, steps_));
      if (mode_ != kRight && mode_ != kLeft) {
        left_ = left_of(at_, steps_);
        left_near_ = left_near;
      }
      if (!below_near_) {
        below_ = below(at_, steps_);
        below_near_ = has_row_below && is_near(below_);
      }
      if (mode_ != kLeft && can_go_right && is_near(right_of(at_, steps_))) {
        next = kRight;
      } else if (mode_ == kLeft ? left_near : left_near_) {
        next = kLeft;
      }
    } else {
      bool rises_right = true, rises_left = true;  // all edges that fail
    Edges:
      for (int i = 0; i < 3; ++i) {
        HS_UNROLL
        rises_right = rises_right && (!is_outside<F>(at_.e[i]) || steps_.rises_right[i]);
        rises_left = rises_left && (!is_outside<F>(at_.e[i]) || steps_.rises_left[i]);
      }
      if (rises_right && mode_ != kSearchLeft && can_go_right) {
        next = kSearchRight;
      } else if (rises_left && mode_ != kSearchRight && can_go_left) {
        next = kSearchLeft;
      }
    }
    if (next == kRight || next == kSearchRight) {
      at_ = right_of(at_, steps_);
    } else if (next == kLeft && mode_ != kLeft) {
      at_ = left_;
    } else if (next == kLeft || next == kSearchLeft) {
      at_ = left_of(at_, steps_);
    } else {
      at_ = below_near_ ? below_ : below(at_, steps_);
      below_near_ = false;
      walks_ = has_row_below;
    }
    mode_ = next;
    return sends;
  }

  // The last stamp of the triangle, with an empty mask if it has none.
  HS_INLINE void finish(Stamp<F>& out) const {
    out = found_;
    out.triangle_last = from_raw<Bit>(1);
    out.last = in_.last;
  }

 private:
  // To where the walk goes: on in the row, or to the next one for kSearch.
  enum Mode : std::uint8_t { kSearch, kSearchRight, kSearchLeft, kRight, kLeft };

  Setup<F> in_;
  WalkSteps<F> steps_;
  WalkPosition<F> at_, left_, below_;
  bool left_near_, below_near_;
  Mode mode_;
  Stamp<F> found_;
  bool pending_, walks_;
};

// A step that visits a stamp or ends the triangle. Returns whether it ended.
template <class F>
HS_INLINE inline bool raster_pineda_step(const Frame<F>& frame, RasterPineda<F>& unit, Stream<Stamp<F>>& stamp) {
  Stamp<F> out;
  const bool ends = !unit.walks();
  bool sends = true;
  if (ends) {
    unit.finish(out);
  } else {
    sends = unit.visit(frame, out);
  }
  if (sends) stamp.write(out);
  return ends;
}

// One triangle.
template <class F>
bool raster_pineda(const Frame<F>& frame, Stream<Setup<F>>& setup, Stream<Stamp<F>>& stamp,
                   Stream<TriangleDepth<F>>& depth_plane, Probe<int>& visits) {
  RasterPineda<F> unit;
  unit.take(setup.read());
  if (F::kTestsPlanes) depth_plane.write(unit.depth_plane());
  int count = 0;
Walk:
  while (!raster_pineda_step(frame, unit, stamp)) {
    HS_PIPELINE(1)
    ++count;
  }
  visits.write(count);
  return unit.is_last();
}

// Those of a frame, in one loop: a step takes a triangle, visits a stamp or ends the triangle.
template <class F>
void raster_pineda_frame(const Frame<F>& frame, Stream<Setup<F>>& setup, Stream<Stamp<F>>& stamp,
                         Stream<TriangleDepth<F>>& depth_plane, Probe<int>& visits) {
  RasterPineda<F> unit{};
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
    } else if (raster_pineda_step(frame, unit, stamp)) {
      visits.write(count);
      has_triangle = false;
      done = unit.is_last();
    } else {
      ++count;
    }
  }
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_RASTER_RASTER_PINEDA_HPP_
