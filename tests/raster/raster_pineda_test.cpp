// SPDX-License-Identifier: Apache-2.0
// Coverage of the kernels against exact integer arithmetic: 0 mismatches.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "tests/raster/kernel_coverage.hpp"

namespace halfspace::tests {
namespace {

using ref::SnappedTriangle;

SnappedTriangle triangle(std::array<int, 3> x, std::array<int, 3> y) {
  SnappedTriangle t{};
  for (int v = 0; v < 3; ++v) t.x[v] = x[v], t.y[v] = y[v];
  return t;
}

// All ordered triples of the points of a grid × grid lattice of half-pixel pitch.
template <class F>
void expect_lattice(int grid) {
  const int size = grid / 2 + 1;
  CoverageKernel<F> kernel(size, size);
  const int half = 1 << (F::kSubpixelBits - 1);
  const int points = grid * grid;
  std::int64_t triangles = 0, covered = 0;
  for (int a = 0; a < points; ++a) {
    for (int b = 0; b < points; ++b) {
      for (int c = 0; c < points; ++c) {
        const SnappedTriangle t = triangle({a % grid * half, b % grid * half, c % grid * half},
                                           {a / grid * half, b / grid * half, c / grid * half});
        ASSERT_EQ(kernel.mismatches(t), 0) << "points " << a << ", " << b << ", " << c << " of the lattice";
        covered += kernel.covered_stamps;
        ++triangles;
      }
    }
  }
  EXPECT_EQ(triangles, std::int64_t(points) * points * points);
  EXPECT_GT(covered, 0);
}

int lattice_grid() {
  const char* grid = std::getenv("HALFSPACE_LATTICE");
  return grid ? std::atoi(grid) : 8;
}

TEST(RasterPineda, CoversTheLatticeExactlyWithOneLane) { expect_lattice<Formats<Low, Stamp1>>(lattice_grid()); }
TEST(RasterPineda, CoversTheLatticeExactlyWithFourLanes) { expect_lattice<Formats<Middle, Stamp4>>(lattice_grid()); }
TEST(RasterPineda, CoversTheLatticeExactlyWithSixteenLanes) { expect_lattice<Formats<High, Stamp16>>(lattice_grid()); }

// Triangles that are hard on an edge function, a class after the other.
template <class F>
SnappedTriangle adversarial(std::mt19937_64& random, int kind, int width, int height) {
  const int one = 1 << F::kSubpixelBits;
  const int limit = 1 << (F::table().coord.width - 1);
  auto in = [&](std::int64_t low, std::int64_t high) {
    return int(low + std::int64_t(random() % std::uint64_t(high - low + 1)));
  };
  auto centre = [&](int size) { return in(-2, size + 1) * one + one / 2; };
  const int w = width * one, h = height * one;
  SnappedTriangle t{};
  for (int v = 0; v < 3; ++v) t.x[v] = in(-w / 4, w + w / 4), t.y[v] = in(-h / 4, h + h / 4);
  switch (kind) {
    case 0: break;  // any
    case 1:
      for (int v = 0; v < 3; ++v) t.x[v] = in(0, 4 * one), t.y[v] = in(0, 4 * one);
      break;  // small
    case 2:
      for (int v = 0; v < 3; ++v) t.x[v] = centre(width), t.y[v] = centre(height);
      break;                                                                  // on centres
    case 3: t.x[1] = t.x[0] + in(-3, 3), t.y[1] = t.y[0] + in(-3, 3); break;  // sliver across the frame
    case 4: t.y[1] = t.y[0] = centre(height); break;                          // horizontal edge through centres
    case 5: t.x[1] = t.x[0] = centre(width); break;                           // vertical edge through centres
    case 6:                                                                   // diagonal through centres
      t.x[0] = centre(width), t.y[0] = centre(height);
      t.x[1] = t.x[0] + in(-20, 20) * one, t.y[1] = t.y[0] + in(-20, 20) * one;
      break;
    case 7:  // ends of the guard band
      for (int v = 0; v < 3; ++v) {
        t.x[v] = in(0, 1) ? in(-limit, -limit + 2) : in(limit - 3, limit - 1);
        t.y[v] = in(0, 2) ? in(-limit, limit - 1) : (in(0, 1) ? -limit : limit - 1);
      }
      break;
    case 8: t.x[2] = t.x[0] + 2 * (t.x[1] - t.x[0]) / 3, t.y[2] = t.y[0] + 2 * (t.y[1] - t.y[0]) / 3; break;  // D ≈ 0
    case 9: t.y[1] = t.y[0] + in(-2, 2), t.y[2] = t.y[0] + in(-one, one); break;     // lying needle
    case 10: t.x[1] = t.x[0] + in(-2, 2), t.x[2] = t.x[0] + in(-one, one); break;    // standing needle
    case 11: t.x[0] = in(-limit, limit - 1), t.y[0] = in(-limit, limit - 1); break;  // one vertex far away
  }
  for (int v = 0; v < 3; ++v) {
    t.x[v] = std::max(-limit, std::min(limit - 1, t.x[v]));
    t.y[v] = std::max(-limit, std::min(limit - 1, t.y[v]));
  }
  return t;
}

template <class F>
void expect_adversarial(int each, int width, int height) {
  CoverageKernel<F> kernel(width, height);
  std::mt19937_64 random(20261122);
  for (int kind = 0; kind < 12; ++kind) {
    std::int64_t fragments = 0;
    for (int n = 0; n < each; ++n) {
      const SnappedTriangle t = adversarial<F>(random, kind, width, height);
      ASSERT_EQ(kernel.mismatches(t), 0) << "class " << kind << ": (" << t.x[0] << ", " << t.y[0] << ") (" << t.x[1]
                                         << ", " << t.y[1] << ") (" << t.x[2] << ", " << t.y[2]
                                         << ") in sub-pixels of 1/" << (1 << F::kSubpixelBits);
      fragments += kernel.covered_stamps;
    }
    EXPECT_GT(fragments, 0) << "class " << kind << " covers nothing";
  }
}

// 12 classes × 5 stamps × 3 configurations: 129,600 triangles in all.
template <class Stamp>
void expect_adversarial_everywhere() {
  expect_adversarial<Formats<Low, Stamp>>(720, 37, 29);
  expect_adversarial<Formats<Middle, Stamp>>(720, 37, 29);
  expect_adversarial<Formats<High, Stamp>>(720, 61, 45);
}
TEST(RasterPineda, CoversAdversarialTrianglesExactly1) { expect_adversarial_everywhere<Stamp1>(); }
TEST(RasterPineda, CoversAdversarialTrianglesExactly2) { expect_adversarial_everywhere<Stamp2>(); }
TEST(RasterPineda, CoversAdversarialTrianglesExactly4) { expect_adversarial_everywhere<Stamp4>(); }
TEST(RasterPineda, CoversAdversarialTrianglesExactly8) { expect_adversarial_everywhere<Stamp8>(); }
TEST(RasterPineda, CoversAdversarialTrianglesExactly16) { expect_adversarial_everywhere<Stamp16>(); }

// A mesh over the frame, its inner vertices anywhere on the sub-pixel grid: each pixel exactly once.
template <class F>
void expect_no_holes_or_doubles(int meshes, int width, int height, int cells) {
  std::mt19937_64 random(7);
  CoverageKernel<F> kernel(width, height);
  const int one = 1 << F::kSubpixelBits;
  for (int m = 0; m < meshes; ++m) {
    const int pitch_x = width * one / cells, pitch_y = height * one / cells;
    std::vector<int> x((cells + 1) * (cells + 1)), y(x.size());
    for (int j = 0; j <= cells; ++j) {
      for (int i = 0; i <= cells; ++i) {
        const bool rim_x = i == 0 || i == cells, rim_y = j == 0 || j == cells;
        // Cells stay convex enough: a vertex moves by less than a third of the pitch, and not off the rim.
        x[j * (cells + 1) + i] = rim_x ? (i ? width * one : 0) : i * pitch_x + int(random() % (pitch_x / 3));
        y[j * (cells + 1) + i] = rim_y ? (j ? height * one : 0) : j * pitch_y + int(random() % (pitch_y / 3));
      }
    }
    std::vector<int> count(width * height);
    for (int j = 0; j < cells; ++j) {
      for (int i = 0; i < cells; ++i) {
        const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
        const bool other = random() % 2;
        for (const std::array<int, 3>& v : {other ? std::array<int, 3>{a, b, d} : std::array<int, 3>{a, b, c},
                                            other ? std::array<int, 3>{a, d, c} : std::array<int, 3>{b, d, c}}) {
          const std::vector<int>& covered =
              kernel.draw(triangle({x[v[0]], x[v[1]], x[v[2]]}, {y[v[0]], y[v[1]], y[v[2]]}));
          for (std::size_t p = 0; p < count.size(); ++p) count[p] += covered[p];
        }
      }
    }
    for (int p = 0; p < width * height; ++p) {
      ASSERT_EQ(count[p], 1) << "mesh " << m << ", pixel (" << p % width << ", " << p / width << ")";
    }
  }
}
// With the larger lattice: 108 Mpx, 1,081,440 shared edges.
TEST(RasterPineda, MeshesHaveNoHolesAndNoDoubles) {
  const bool all = lattice_grid() > 8;
  expect_no_holes_or_doubles<Formats<Low, Stamp1>>(all ? 860 : 20, 96, 64, 12);
  expect_no_holes_or_doubles<Formats<Middle, Stamp4>>(all ? 860 : 20, 96, 64, 12);
  expect_no_holes_or_doubles<Formats<High, Stamp16>>(all ? 860 : 20, 96, 64, 12);
  expect_no_holes_or_doubles<Formats<Middle, Stamp16>>(all ? 300 : 4, 640, 480, 6);
}

// Cycles of the walk beyond the stamps it must send: what the search and the corners cost.
TEST(RasterPineda, SendsEachStampOnceAndOnlyCoveredOnes) {
  CoverageKernel<Formats<Middle, Stamp4>> kernel(64, 64);
  kernel.draw(triangle({10 << 8, 50 << 8, 20 << 8}, {5 << 8, 30 << 8, 60 << 8}));
  EXPECT_EQ(kernel.stamps, kernel.covered_stamps);
  EXPECT_GT(kernel.stamps, 100);
  kernel.draw(triangle({70 << 8, 90 << 8, 80 << 8}, {5 << 8, 30 << 8, 60 << 8}));
  EXPECT_EQ(kernel.stamps, 1);
  EXPECT_EQ(kernel.covered_stamps, 0);
}

}  // namespace
}  // namespace halfspace::tests
