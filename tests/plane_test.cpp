// SPDX-License-Identifier: Apache-2.0
// Depth and colour planes before rounding, against exact arithmetic: the bound of hls/plane.hpp holds at every covered
// pixel centre of every kind of triangle, slivers above all.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "hls/configs/high.hpp"
#include "hls/configs/low.hpp"
#include "hls/configs/middle.hpp"
#include "hls/pipeline.hpp"
#include "ref/raster.hpp"

namespace halfspace::tests {
namespace {

using Wide = __int128;

// |V − exact| in LSB, V the plane's value without its ½, taken modulo 2^b, nearest to the exact value.
// exact = v0 + (N_A·dx + N_B·dy) / D, all in integers of sub-pixels.
double plane_error(std::uint64_t value, int bits, int fraction, Wide numerator, Wide area) {
  const Wide scale = Wide(1) << fraction;
  // (value/2^g − ½) − numerator/area, times area·2^g.
  Wide error = (Wide(value) - scale / 2) * area - numerator * scale;
  const Wide period = (Wide(1) << (bits + fraction)) * area;
  error %= period;
  if (error > period / 2) error -= period;
  if (error < -period / 2) error += period;
  return std::fabs(double(error) / double(area) / double(scale));
}

struct Worst {
  double depth = 0, colour = 0, depth_share = 0, colour_share = 0;  // shares of the bound of the very pixel
  std::uint64_t fragments = 0;
};

template <class F>
class PlaneProbe {
 public:
  PlaneProbe(int width, int height) {
    frame_.width = from_raw<typename F::X>(width);
    frame_.height = from_raw<typename F::Y>(height);
  }

  void draw(const ref::SnappedTriangle& in, Worst& worst) {
    Triangle<F> t{};
    for (int v = 0; v < 3; ++v) {
      t.x[v] = from_raw<typename F::Coord>(in.x[v]), t.y[v] = from_raw<typename F::Coord>(in.y[v]);
      t.depth[v] = from_raw<typename F::Depth>(in.depth[v]);
      t.r[v] = from_raw<typename F::Colour>(in.rgb[v][0]);
    }
    triangle_.write(t);
    triangle_setup(frame_, triangle_, setup_, attributes_);
    if (attributes_.empty()) {
      setup_.read();
      return;
    }
    shade_setup(attributes_, planes_);
    const Planes<F> planes = planes_.read();
    const Setup<F> setup = setup_.read();
    setup_.write(setup);
    raster_pineda(frame_, setup_, stamp_, visits_);
    while (!stamp_.empty()) {
      const Stamp<F> s = stamp_.read();
      for (int l = 0; l < F::kLanes; ++l) {
        if (raw(s.mask[l])) fragment(in, setup, planes, int(raw(s.x)) + l % F::kLanesX, int(raw(s.y)), worst);
      }
    }
  }

 private:
  void fragment(const ref::SnappedTriangle& t, const Setup<F>& setup, const Planes<F>& planes, int x, int y, Worst& worst) {
    static_assert(F::kLanes == 1, "stamps are pixels here");
    ++worst.fragments;
    const std::uint64_t depth = raw(setup.depth) +
                                std::uint64_t(std::int64_t(raw(setup.depth_dx)) * (x - int(raw(setup.x_start))) +
                                              std::int64_t(raw(setup.depth_dy)) * (y - int(raw(setup.y_min))));
    const std::uint64_t red = raw(planes.r) + std::uint64_t(std::int64_t(raw(planes.r_dx)) * x + std::int64_t(raw(planes.r_dy)) * y);
    const int f = F::kSubpixelBits;
    const Wide dx1 = t.x[1] - t.x[0], dy1 = t.y[1] - t.y[0], dx2 = t.x[2] - t.x[0], dy2 = t.y[2] - t.y[0];
    const Wide area = dx1 * dy2 - dx2 * dy1;
    const Wide sign = area < 0 ? -1 : 1;
    const Wide dx = (Wide(x) << f) + (1 << (f - 1)) - t.x[0], dy = (Wide(y) << f) + (1 << (f - 1)) - t.y[0];
    auto numerator = [&](Wide v0, Wide v1, Wide v2) {
      return sign * (v0 * area + ((v1 - v0) * dy2 - (v2 - v0) * dy1) * dx + ((v2 - v0) * dx1 - (v1 - v0) * dx2) * dy);
    };
    // Distance from the vertex that the kernel measures from: at most the farthest one's.
    double reach = 0;
    for (int v = 0; v < 3; ++v) {
      reach = std::max(reach, std::fabs(x + 0.5 - std::ldexp(t.x[v], -f)) + std::fabs(y + 0.5 - std::ldexp(t.y[v], -f)));
    }
    const double depth_bound = std::ldexp(1, F::kDepthBits - F::kReciprocalFraction) + std::ldexp(reach, -F::kDepthFraction - 1);
    const double colour_bound = std::ldexp(1, 8 - F::kReciprocalFraction) + std::ldexp(reach, -F::kColourFraction - 1);
    const double depth_error = plane_error(depth & ((std::uint64_t(1) << F::kDepthPlaneBits) - 1), F::kDepthBits,
                                           F::kDepthFraction, numerator(t.depth[0], t.depth[1], t.depth[2]), sign * area);
    const double colour_error = plane_error(red & ((std::uint64_t(1) << F::kColourPlaneBits) - 1), 8, F::kColourFraction,
                                            numerator(t.rgb[0][0], t.rgb[1][0], t.rgb[2][0]), sign * area);
    // The start was cut to g bits: up to 2^−g below, which no rounded value can see.
    const double depth_cut = std::ldexp(1, -F::kDepthFraction), colour_cut = std::ldexp(1, -F::kColourFraction);
    EXPECT_LE(depth_error, depth_bound + depth_cut);
    EXPECT_LE(colour_error, colour_bound + colour_cut);
    worst.depth = std::max(worst.depth, depth_error);
    worst.colour = std::max(worst.colour, colour_error);
    worst.depth_share = std::max(worst.depth_share, depth_error / (depth_bound + depth_cut));
    worst.colour_share = std::max(worst.colour_share, colour_error / (colour_bound + colour_cut));
  }

  Frame<F> frame_{};
  Stream<Triangle<F>> triangle_;
  Stream<Setup<F>> setup_;
  Stream<Attributes<F>> attributes_;
  Stream<Planes<F>> planes_;
  Stream<Stamp<F>> stamp_;
  Probe<int> visits_;
};

template <class F>
void expect_bounds(int triangles) {
  PlaneProbe<F> probe(F::kWidth, F::kHeight);
  std::mt19937_64 random(3);
  auto in = [&](std::int64_t low, std::int64_t high) { return int(low + std::int64_t(random() % std::uint64_t(high - low + 1))); };
  const int one = 1 << F::kSubpixelBits, limit = 1 << (F::table().coord.width - 1);
  const std::uint32_t full = std::uint32_t((std::uint64_t(1) << F::kDepthBits) - 1);
  const char* const names[] = {"small", "sliver across the frame", "sliver across the guard band", "any", "guard band"};
  for (int kind = 0; kind < 5; ++kind) {
    Worst worst;
    for (int n = 0; n < triangles && !testing::Test::HasFailure(); ++n) {
      ref::SnappedTriangle t{};
      const int w = F::kWidth * one, h = F::kHeight * one;
      const int cx = in(0, w), cy = in(0, h);
      for (int v = 0; v < 3; ++v) {
        const int spread = kind == 0 ? 8 * one : kind == 3 ? 60 * one : 0;
        t.x[v] = spread ? cx + in(-spread, spread) : kind == 1 ? in(0, w) : in(-limit, limit - 1);
        t.y[v] = spread ? cy + in(-spread, spread) : kind == 1 ? in(0, h) : in(-limit, limit - 1);
        t.depth[v] = in(0, 1) ? std::uint32_t(in(0, 1)) * full : std::uint32_t(random() % (full + 1ull));
        t.rgb[v][0] = in(0, 1) ? std::uint8_t(255 * in(0, 1)) : std::uint8_t(in(0, 255));
      }
      if (kind == 1 || kind == 2) t.x[1] = t.x[0] + in(-3, 3), t.y[1] = t.y[0] + in(-3, 3);
      if (kind == 4) {
        // A sliver again, aimed at the frame from a corner of the guard band, so that distances are the largest.
        t.x[0] = in(0, 1) ? -limit : limit - 1, t.y[0] = in(0, 1) ? -limit : limit - 1;
        t.x[1] = cx, t.y[1] = cy, t.x[2] = cx + in(-2, 2), t.y[2] = cy + in(-2, 2);
      }
      for (int v = 0; v < 3; ++v) {
        t.x[v] = std::max(-limit, std::min(limit - 1, t.x[v])), t.y[v] = std::max(-limit, std::min(limit - 1, t.y[v]));
      }
      probe.draw(t, worst);
    }
    EXPECT_GT(worst.fragments, 0u);
    std::printf("%-7s %-29s %9llu fragments: depth %.4f LSB (%2.0f %% of the bound), colour %.4f LSB (%2.0f %%)\n",
                F::config().name, names[kind], static_cast<unsigned long long>(worst.fragments), worst.depth,
                100 * worst.depth_share, worst.colour, 100 * worst.colour_share);
    EXPECT_LE(worst.depth, 0.39) << "the goal for depth before rounding";
    EXPECT_LE(worst.colour, 1.0 / 16) << "the goal for colour before rounding";
  }
}

TEST(Plane, StaysWithinItsBoundInLow) { expect_bounds<Formats<Low, Stamp1>>(1200); }
TEST(Plane, StaysWithinItsBoundInMiddle) { expect_bounds<Formats<Middle, Stamp1>>(1200); }
TEST(Plane, StaysWithinItsBoundInHigh) { expect_bounds<Formats<High, Stamp1>>(1200); }

// R = round(2^(r+s) / D), ties up, for every kind of D.
template <class F>
void expect_reciprocal() {
  std::mt19937_64 random(5);
  const int r = F::kReciprocalFraction;
  for (int n = 0; n < 200000; ++n) {
    const int width = 1 + n % F::kAreaBits;
    std::uint64_t area = (random() & ((std::uint64_t(1) << width) - 1)) | std::uint64_t(1) << (width - 1);
    if (n % 7 == 0) area = std::uint64_t(1) << (width - 1);
    if (n % 7 == 1) area = (std::uint64_t(1) << width) - 1;
    const auto result = area_reciprocal<F>(from_raw<typename F::Area>(area));
    int s = 63;
    while (!(area >> s)) --s;
    const Wide exact = ((Wide(1) << (r + s + 1)) + Wide(area)) / (2 * Wide(area));
    ASSERT_EQ(int(raw(result.shift)), s) << "D = " << area;
    ASSERT_EQ(std::uint64_t(raw(result.reciprocal)), std::uint64_t(exact)) << "D = " << area;
  }
}
TEST(Reciprocal, IsRoundedCorrectly) {
  expect_reciprocal<Formats<Low, Stamp1>>();
  expect_reciprocal<Formats<Middle, Stamp1>>();
  expect_reciprocal<Formats<High, Stamp1>>();
}

}  // namespace
}  // namespace halfspace::tests
