// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "study/bounds/bounds_measure.hpp"

namespace halfspace::model {

void TriangleMeter::search(TriangleSource& source, Vertices vertices, PlaneKind kind, int steps) {
  const int x = width_ - 1, y = height_ - 1;
  const auto channel = std::find_if(channels_.begin(), channels_.end(), [&](const auto& c) { return c.kind == kind; });
  auto badness = [&](const ref::SnappedTriangle& t) {
    const ExactTriangle exact(t, config_.subpixel_bits);
    const ProbedSetup setup = probe_->setup(t);
    const PixelSpan span = exact.span(y, width_);
    if (setup.empty || span.first > x || span.last < x) return 0.0;
    double worst = 0;
    for (int c = 0; c < components(kind); ++c) {
      worst = std::max(worst, std::fabs(plane_error(channel->numbers, exact, values_of(exact, *channel, c),
                                                    plane_of(setup, kind, c), x, y)));
    }
    return worst;
  };
  // A new start when nothing was gained for a while; the best of each climb is measured in full.
  constexpr int kPatience = 200;
  ref::SnappedTriangle best{};
  double height = 0;
  int idle = kPatience;
  for (int n = 0; n < steps; ++n) {
    if (idle >= kPatience) {
      if (height > 0) measure(best);
      best = source.farthest(vertices);
      height = badness(best);
      idle = 0;
      continue;
    }
    const ref::SnappedTriangle next = source.changed(best, vertices);
    const double at = badness(next);
    ++idle;
    if (at <= height) continue;
    best = next, height = at, idle = 0;
  }
  measure(best);
}

}  // namespace halfspace::model
