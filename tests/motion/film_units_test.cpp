// SPDX-License-Identifier: Apache-2.0
// What the units of films do at their edges: frames that are no whole tiles or stamps, holes one behind the other and
// last, frames without any; and the configurations that make no films.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "model/pipeline/kernels/film.hpp"
#include "tests/config_path.hpp"

namespace halfspace {
namespace {

using F = RuntimeFormats<Stamp4>;

class FilmUnits : public testing::Test {
 protected:
  FilmUnits() {
    const Config config = model::find_configuration(config_path("film_phong")).config();
    F::activate(config, format_table(config));
  }

  static Frame<F> frame(int width, int height) {
    Frame<F> out{};
    out.width = from_raw<F::X>(width), out.height = from_raw<F::Y>(height);
    out.r = out.g = out.b = from_raw<F::Colour>(7);
    return out;
  }
};

TEST_F(FilmUnits, TilesOfEveryFrameComeInTheirOrder) {
  for (int height = 1; height <= 19; ++height) {
    for (int width = 1; width <= 19; ++width) {
      std::vector<std::tuple<int, int, int, int>> expected, got;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) expected.emplace_back(y / 8, x / 8, y, x);
      }
      std::sort(expected.begin(), expected.end());
      for (TilePlace at; at.y < height; at = next_in_tiles(at, width, height))
        got.emplace_back(at.y / 8, at.x / 8, at.y, at.x);
      ASSERT_EQ(got, expected) << width << "x" << height;
    }
  }
}

TEST_F(FilmUnits, TheLastWordOfAFieldSaysSo) {
  MotionBuffer<F> buffer;
  Stream<Motion<F>> motion, ordered;
  for (const int words : {0, 1, 2}) {
    for (int n = 0; n <= words; ++n) {
      Motion<F> word{};
      word.last = from_raw<Bit>(n == words);
      word.x = from_raw<F::X>(9 - 9 * n);
      word.face = from_raw<F::Face>(n == words ? 0 : n + 1);
      motion.write(word);
      EXPECT_EQ(store_motion(motion, buffer), n == words);
    }
    motion_order(frame(10, 1), buffer, ordered);
    std::vector<int> faces;
    while (!ordered.empty()) {
      const Motion<F> word = ordered.read();
      faces.push_back(int(raw(word.face)));
      EXPECT_EQ(is_set(word.last), ordered.empty());
    }
    EXPECT_EQ(faces, words == 0 ? std::vector<int>{0} : words == 1 ? std::vector<int>{1} : (std::vector<int>{2, 1}));
  }
}

// Faces of a row of pixels, negative where no key shows them: what is asked for, and how many are marked.
std::vector<int> asked_for(const std::vector<int>& row, int* marked) {
  Stream<Motion<F>> ordered;
  Stream<Compensated<F>> compensated;
  Stream<Asked<F>> asked;
  FilmBuffer<F> film;
  HoleMarks<F> marks;
  F::Face held = from_raw<F::Face>(0);
  bool done = false;
  for (std::size_t n = 0; n < row.size(); ++n) {
    Motion<F> motion{};
    Compensated<F> made{};
    motion.face = from_raw<F::Face>(std::abs(row[n]));
    made.last = motion.last = from_raw<Bit>(n + 1 == row.size());
    made.x = motion.x = from_raw<F::X>(n);
    made.keys = from_raw<Keys>(row[n] > 0 ? 2 : 0);
    ordered.write(motion), compensated.write(made);
    EXPECT_FALSE(done);
    done = hole_find(ordered, compensated, film, marks, held, asked);
    EXPECT_EQ(is_set(film.pixel[n].shown), row[n] > 0);
  }
  EXPECT_TRUE(done);
  EXPECT_TRUE(is_zero(held));
  *marked = 0;
  for (const auto& stamp : marks.hole) {
    for (int l = 0; l < F::kLanes; ++l) *marked += is_set(Bit(stamp[l]));
  }
  std::vector<int> faces;
  while (!asked.empty()) {
    const Asked<F> word = asked.read();
    faces.push_back(int(raw(word.face)));
    EXPECT_EQ(is_set(word.last), asked.empty());
  }
  return faces;
}

TEST_F(FilmUnits, AFaceIsAskedForOnceForHolesThatFollowEachOther) {
  int marked = 0;
  EXPECT_EQ(asked_for({1, 2, 0}, &marked), (std::vector<int>{0}));
  EXPECT_EQ(marked, 0);
  EXPECT_EQ(asked_for({0}, &marked), (std::vector<int>{0}));
  EXPECT_EQ(asked_for({-3, -3, 1, -3, 0}, &marked), (std::vector<int>{3}));
  EXPECT_EQ(marked, 3);
  EXPECT_EQ(asked_for({-3, -4, -3}, &marked), (std::vector<int>{3, 4, 3}));
  EXPECT_EQ(asked_for({-3, 2, -4}, &marked), (std::vector<int>{3, 4}));
  EXPECT_EQ(marked, 2);
}

TEST_F(FilmUnits, StampsWithoutAHoleAreDroppedButForTheLast) {
  Stream<Scan<F>> scan, masked;
  HoleMarks<F> marks;
  mark_hole<F>(3, 0, marks);  // lane 1 of the second stamp
  // As scan-out, with the hole, and with none: its mark is cleared.
  const std::vector<int> expected[] = {std::vector<int>(16, 5), {0, 5, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}};
  for (int pass = 0; pass < 3; ++pass) {
    for (int n = 0; n < 4; ++n) {
      Scan<F> word{};
      word.x = from_raw<F::X>(n);
      word.last = from_raw<Bit>(n == 3);
      for (auto& index : word.index) index = from_raw<F::Index>(5);
      scan.write(word);
    }
    hole_scan_frame(pass != 0, scan, marks, masked);
    std::vector<int> indices;
    while (!masked.empty()) {
      const Scan<F> word = masked.read();
      for (const auto& index : word.index) indices.push_back(int(raw(index)));
      EXPECT_EQ(is_set(word.last), masked.empty());
    }
    EXPECT_EQ(indices, expected[pass]) << "pass " << pass;
  }
}

TEST_F(FilmUnits, PixelsOutsideTheFrameAreNotStored) {
  Stream<Scan<F>> scan;
  Stream<Pixel<F>> pixel;
  Stream<ShownPixel<F>> shown;
  FaceTable<F> faces;
  faces.face[4] = from_raw<F::Face>(9);
  Scan<F> in{};
  Pixel<F> colours{};
  in.x = from_raw<F::X>(1), in.y = from_raw<F::Y>(1), in.last = from_raw<Bit>(1);
  in.index[2] = from_raw<F::Index>(5);
  scan.write(in), pixel.write(colours);
  EXPECT_TRUE(pixel_store(frame(3, 4), scan, pixel, faces, shown));
  const ShownPixel<F> above = shown.read(), below = shown.read();
  EXPECT_TRUE(shown.empty());
  EXPECT_EQ(raw(above.x), 2u);
  EXPECT_EQ(raw(above.face), 0u);
  EXPECT_FALSE(is_set(above.last) || is_set(above.shown));
  EXPECT_EQ(raw(below.y), 3u);
  EXPECT_EQ(raw(below.face), 9u);
  EXPECT_TRUE(is_set(below.last) && is_set(below.shown));

  scan.write(in), pixel.write(colours);
  EXPECT_TRUE(pixel_store(frame(4, 3), scan, pixel, faces, shown));
  EXPECT_EQ(raw(shown.read().x), 2u);
  const ShownPixel<F> right = shown.read();
  EXPECT_TRUE(shown.empty());
  EXPECT_EQ(raw(right.x), 3u);
  EXPECT_TRUE(is_set(right.last));
}

TEST(FilmConfigurations, WeightsAreThoseOfTheWay) {
  Config config = model::find_configuration(config_path("film_phong")).config();
  for (config.frames_between = 1; config.frames_between <= 9; ++config.frames_between) {
    for (config.weight_bits = 2; config.weight_bits <= 8; ++config.weight_bits) {
      for (int i = 1; i <= config.frames_between; ++i) {
        const double way = double(i) / (config.frames_between + 1);
        EXPECT_EQ(field_weight(config, i), int(std::floor((1 - way) * (1 << config.weight_bits) + 0.5)));
      }
    }
  }
}

TEST(FilmConfigurations, WhatMakesNoFilmsIsRefused) {
  const model::Configuration configuration = model::find_configuration(config_path("film_middle"));
  const Config film = configuration.config();
  const auto refused = [&](auto change) { return refusal_of(film, change); };
  EXPECT_EQ(refusal_of(film), "accepted");
  EXPECT_EQ(refused([](Config& c) { c.frames_between = 9; }), "accepted");
  EXPECT_NE(refused([](Config& c) { c.frames_between = 10; }).find("frames_between is 1 to 9"), std::string::npos);
  EXPECT_NE(refused([](Config& c) { c.shading = Shading::kMotion; }).find("shades none"), std::string::npos);
  EXPECT_NE(refused([](Config& c) { c.samples = 2; }).find("samples is 1"), std::string::npos);
  EXPECT_NE(refused([](Config& c) { c.object_bits = 4; }).find("object_bits is 0"), std::string::npos);
  EXPECT_NE(refused([](Config& c) { c.filter = KeyFilter::kNone; }).find("take a filter"), std::string::npos);
  EXPECT_NE(
      refused([](Config& c) { c.frames_between = 0; }).find("where shading is not \"motion\" and frames_between is 0"),
      std::string::npos);
}

}  // namespace
}  // namespace halfspace
