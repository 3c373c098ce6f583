// SPDX-License-Identifier: Apache-2.0
// The ideal picture, what is measured against it, and the intervals that the model of cycles starts from. The model
// itself is held to the co-simulation by sweep_test.py.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/geometry/geometry.hpp"
#include "ref/raster/ideal.hpp"
#include "ref/raster/ideal_scene.hpp"
#include "ref/scene/scene.hpp"
#include "study/trade/trade.hpp"

namespace halfspace::tests {
namespace {

using ref::IdealFrame;
using ref::TriangleList;

// On a grid the ideal picture is the reference's, which computes otherwise.
TEST(Ideal, OfSnappedTrianglesIsTheReference) {
  for (const char* name : {"teapot", "castle"}) {
    const ref::RasterFormat format{"grid", 320, 240, 1 << 20, 11, 5, 32};
    const ref::SnappedList snapped = ref::snap(ref::project(ref::load_scene(name), {320, 240, 11, 5}), format);
    const ref::Frame reference = ref::render(snapped);
    const IdealFrame ideal = ref::ideal(ref::unsnap(snapped));
    std::size_t differ = 0, covered = 0;
    for (std::size_t n = 0; n < ideal.face.size(); ++n) {
      ASSERT_EQ(ideal.face[n] == 0, reference.index[n] == 0) << name << " pixel " << n;
      differ += ideal.face[n] != reference.index[n];  // depths less than 2^-32 apart
      if (ideal.face[n] == 0 || ideal.face[n] != reference.index[n]) continue;
      ++covered;
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(ideal.colour[n][c], reference.exact_colour[n][c], 1e-9);
      ASSERT_NEAR(ideal.depth[n] * 0xffffffff, reference.exact_depth[n], 1e-3);
    }
    EXPECT_LE(differ, 2u) << name;
    EXPECT_GT(covered, 10000u) << name;
  }
}

// Triangles of a mesh whose vertices stand on no grid cover each pixel once: at one depth the first drawn wins, so a
// pixel covered twice would show another face when they are drawn in the other order.
TEST(Ideal, CoversAMeshOnce) {
  constexpr int kWidth = 97, kHeight = 61, kCells = 24;
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<std::array<double, 2>> points;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const bool border = i == 0 || j == 0 || i == kCells || j == kCells;
      const double x = i + (border ? 0 : jitter(random)), y = j + (border ? 0 : jitter(random));
      points.push_back({x * kWidth / kCells, y * kHeight / kCells});
    }
  }
  TriangleList list{kWidth, kHeight, {}, {}};
  const auto add = [&](int a, int b, int c) {
    std::array<ref::Vertex, 3> t{};
    const int corner[] = {a, b, c};
    for (int v = 0; v < 3; ++v) t[v].x = points[corner[v]][0], t[v].y = points[corner[v]][1];
    list.triangles.push_back(t);
    list.face.push_back(std::uint32_t(list.triangles.size()));
  };
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const int at = j * (kCells + 1) + i;
      add(at, at + 1, at + kCells + 1);
      add(at + 1, at + kCells + 2, at + kCells + 1);
    }
  }
  const IdealFrame forward = ref::ideal(list);
  std::reverse(list.triangles.begin(), list.triangles.end());
  std::reverse(list.face.begin(), list.face.end());
  EXPECT_EQ(forward.face, ref::ideal(list).face);
  EXPECT_EQ(std::count(forward.face.begin(), forward.face.end(), 0u), 0);
}

TEST(Ideal, KeepsASliverBetweenItsVertices) {
  // 10^-10 pixels thick along a line through pixel centres.
  TriangleList list{120, 60, {}, {}};
  list.triangles.push_back(
      {{{0.5, 0.5, 0.25, 0, 10, 200}, {100.5, 50.5, 0.5, 255, 20, 200}, {60.5, 30.5 - 1e-10, 0.75, 90, 30, 200}}});
  const IdealFrame ideal = ref::ideal(list);
  int covered = 0;
  for (std::size_t n = 0; n < ideal.face.size(); ++n) {
    if (ideal.face[n] == 0) continue;
    ++covered;
    EXPECT_GE(ideal.depth[n], 0.25 - 1e-12);
    EXPECT_LE(ideal.depth[n], 0.75 + 1e-12);
    EXPECT_GE(ideal.colour[n][1], 10 - 1e-9);
    EXPECT_LE(ideal.colour[n][1], 30 + 1e-9);
    EXPECT_NEAR(ideal.colour[n][2], 200, 1e-9);
  }
  EXPECT_GE(covered, 20);
  list.triangles[0][1].x = 200000;
  EXPECT_THROW(ref::ideal(list), ref::Error);
}

// Of a scene: as its triangles come lit; on flat faces a pixel is lit as a vertex is, and on round ones it is not; what
// bricks multiply is what is there without them.
TEST(Ideal, OfASceneHasItsLightsAndTextures) {
  const ref::View view = ref::ideal_view(120, 90);
  const auto largest = [](const IdealFrame& a, const IdealFrame& b) {
    double error = 0;
    for (std::size_t n = 0; n < a.colour.size(); ++n) {
      for (int c = 0; c < 3; ++c) error = std::max(error, std::abs(a.colour[n][c] - b.colour[n][c]));
    }
    return error;
  };
  const ref::IdealLook given{}, vertices{ref::ShadingMode::kGouraud, true}, pixels{ref::ShadingMode::kPhong, true},
      flat{ref::ShadingMode::kFlat, true};
  const ref::Scene teapot = ref::load_scene("teapot"), cube = ref::load_scene("cube");
  EXPECT_LT(largest(ref::ideal(teapot, view, given), ref::ideal(ref::project(teapot, view))), 1e-9);
  EXPECT_LT(largest(ref::ideal(cube, view, vertices), ref::ideal(cube, view, pixels)), 1e-9);
  EXPECT_LT(largest(ref::ideal(cube, view, vertices), ref::ideal(cube, view, flat)), 1e-9);
  EXPECT_GT(largest(ref::ideal(teapot, view, vertices), ref::ideal(teapot, view, pixels)), 20);
  const ref::Scene bricks = ref::load_scene("cube_fast", 0, {true});
  ref::IdealLook textured{};
  textured.texture = ref::TextureFilter::kBilinear;
  const IdealFrame lit = ref::ideal(bricks, view, given), shown = ref::ideal(bricks, view, textured);
  EXPECT_GT(largest(lit, shown), 20);
  for (std::size_t n = 0; n < lit.colour.size(); ++n) {
    for (int c = 0; c < 3; ++c) ASSERT_LE(shown.colour[n][c], lit.colour[n][c] + 1e-9);
  }
}

// A face has one number whatever the view culls or clips before it.
TEST(Ideal, NumbersFacesWhateverTheView) {
  const ref::Scene scene = ref::load_scene("teapot");
  const TriangleList fine = ref::project(scene, ref::ideal_view(320, 240)),
                     coarse = ref::project(scene, {320, 240, 11, 1});
  EXPECT_NE(fine.triangles.size(), coarse.triangles.size());
  std::map<std::uint32_t, std::size_t> by_face;
  for (std::size_t k = 0; k < fine.triangles.size(); ++k) by_face[fine.face[k]] = k;
  std::size_t common = 0;
  for (std::size_t k = 0; k < coarse.triangles.size(); ++k) {
    const auto found = by_face.find(coarse.face[k]);
    if (found == by_face.end()) continue;
    ++common;
    for (int v = 0; v < 3; ++v) ASSERT_EQ(coarse.triangles[k][v].x, fine.triangles[found->second][v].x);
  }
  EXPECT_GT(common, coarse.triangles.size() * 9 / 10);
}

TEST(Ideal, MovesByWholePixels) {
  const ref::Scene scene = ref::load_scene("castle");
  const IdealFrame at = ref::ideal(ref::project(scene, ref::ideal_view(160, 120)));
  const IdealFrame moved = ref::ideal(ref::project(scene, ref::ideal_view(160, 120, 1, 2)));
  std::size_t differ = 0;
  for (int y = 2; y < 120; ++y) {
    for (int x = 1; x < 160; ++x) differ += moved.face[y * 160 + x] != at.face[(y - 2) * 160 + x - 1];
  }
  EXPECT_LE(differ, 2u);  // centres within a rounding of an edge
  EXPECT_NE(moved.face, at.face);
}

// A picture of 4x1 pixels: face 1 in three, the background in one.
struct Small {
  TriangleList list{4, 1, {}, {{}, {}}};
  IdealFrame ideal{4, 1, {1, 1, 1, 0}, {0.5, 0.5, 0.5, 1}, {{10.25, 20, 30}, {10, 20, 30}, {10, 20, 30}, {0, 0, 0}}};
  std::array<std::uint8_t, 4> shown{10, 20, 30, 255}, black{0, 0, 0, 255};
  ref::Frame frame{4, 1, {1, 1, 1, 0}, {128, 128, 128, 255}, {shown, shown, shown, black}, {}, {}, {}};
};

TEST(Trade, PictureErrorCountsWhatDiffers) {
  Small s;
  s.frame.index[1] = 2;
  s.frame.index[2] = 0;
  s.frame.colour[2] = {0, 0, 0, 255};
  const model::PictureError e = model::picture_error(s.ideal, s.list, s.frame, 8);
  EXPECT_EQ(e.pixels, 4u);
  EXPECT_EQ(e.index_differ, 2u);
  EXPECT_EQ(e.covered_differ, 1u);
  EXPECT_EQ(e.compared, 1u);
  EXPECT_DOUBLE_EQ(e.colour_largest, 0.25);
  EXPECT_DOUBLE_EQ(e.colour_rms, std::sqrt(0.0625 / 3));
  EXPECT_DOUBLE_EQ(e.depth_largest, 0.5);
  EXPECT_DOUBLE_EQ(e.psnr, 10 * std::log10(65025.0 * 12 / (0.0625 + 1400)));
}

TEST(Trade, StoredErrorIsOfTheSameTriangles) {
  Small s;
  ref::Frame reference = s.frame;
  reference.exact_depth = {127.75, 128.5, 0, 0};
  reference.exact_colour = {{10, 20, 30}, {10, 20.25, 30}, {10, 20, 30}, {99, 99, 99}};
  s.frame.index[2] = 2;
  const model::StoredError e = model::stored_error(reference, s.frame, 8);
  EXPECT_DOUBLE_EQ(e.depth_largest, 0.5);
  EXPECT_DOUBLE_EQ(*e.colour_largest, 0.25);
  EXPECT_EQ(model::stored_error(reference, s.frame, 0).depth_largest, 0);
}

TEST(Trade, ShimmerIsWhatChanges) {
  Small s;
  model::ShimmerMeter still, flash;
  for (int k = 0; k < 5; ++k) {
    s.frame.colour[0][1] = 70;
    still.add(s.ideal, s.list, s.frame);
    s.frame.colour[0][1] = k == 2 ? 70 : 20;
    s.frame.index[0] = k == 2 ? 2 : 1;
    flash.add(s.ideal, s.list, s.frame);
    s.frame.index[0] = 1;
  }
  EXPECT_EQ(still.result().rms, 0);
  EXPECT_EQ(still.result().pixels, 0);
  EXPECT_NEAR(flash.result().rms, std::sqrt(2 * 2500.0 / (3 * 4 * 4)), 1e-5);
  EXPECT_DOUBLE_EQ(flash.result().pixels, 0.5);
}

TEST(Trade, SubpixelBitsBuyEdges) {
  const ref::Scene scene = ref::load_scene("teapot");
  const model::Subject subject(std::make_shared<ref::Scene>(scene));
  model::Trade last;
  for (const int f : {1, 4, 7}) {
    Config config = model::find_configuration("middle").config();
    config.subpixel_bits = f;
    const model::Trade trade = model::measure_trade(subject, 160, 120, {"test", config}, 4, {});
    EXPECT_FALSE(trade.compiled);
    EXPECT_GT(trade.native_ms, 0);
    EXPECT_EQ(trade.reference.covered_differ, 0u);
    if (f != 1) {
      EXPECT_LT(trade.ideal.index_differ, last.ideal.index_differ);
      EXPECT_GT(trade.ideal.psnr, last.ideal.psnr);
      EXPECT_LT(trade.shimmer.rms, last.shimmer.rms);
      EXPECT_LT(trade.ideal.depth_rms, last.ideal.depth_rms);
    }
    last = trade;
  }
  EXPECT_GT(last.ideal.psnr, 50);
  EXPECT_GT(last.shimmer.rms, 0);
}

TEST(Trade, WhatIsNotThereHasNoTraffic) {
  const ref::Scene scene = ref::load_scene("cube");
  const model::Subject subject(std::make_shared<ref::Scene>(scene));
  const Config flat{"flat", 160, 120, 100, 9, 6, 0, 8, 0, 0, 0, 4, Shading::kFlat};
  const model::Trade trade = model::measure_trade(subject, 160, 120, {"flat", flat}, 1, {});
  const model::Accesses& a = trade.accesses;
  EXPECT_EQ(a.words.depth.read + a.words.depth.written, 0u);
  EXPECT_EQ(a.words.shading.written, trade.triangles);
  EXPECT_EQ(trade.ideal.depth_largest, 0);
  EXPECT_GE(trade.cycles.frame, 160u * 120);
  // Scan-out reads each index once and writes it once; what is drawn comes on top.
  EXPECT_GT(a.words.index.read, 160u * 120);
  EXPECT_LE(a.words.index.written, a.words.index.read);
  EXPECT_EQ(model::total_bytes(a.words, model::entry_bits(flat)),
            (7 * a.words.index.read + 7) / 8 + (7 * a.words.index.written + 7) / 8 +
                24 / 8 * (a.words.shading.read + trade.triangles));
}

TEST(Trade, IntervalsOfTheNamedConfigurations) {
  const std::map<std::string, std::pair<int, int>> documented = {
      {"low", {21, 24}}, {"middle", {29, 30}}, {"high", {31, 30}}};
  for (const model::Configuration& named : model::named_configurations()) {
    const model::UnitIntervals intervals = model::unit_intervals(named.config());
    EXPECT_EQ(intervals.triangle_setup, documented.at(named.name()).first) << named.name();
    EXPECT_EQ(intervals.shade_setup, documented.at(named.name()).second) << named.name();
  }
}

}  // namespace
}  // namespace halfspace::tests
