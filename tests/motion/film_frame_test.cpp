// SPDX-License-Identifier: Apache-2.0
// Units of films that take a frame at once give what they give by words.
#include <gtest/gtest.h>

#include <random>

#include "model/pipeline/kernels/film.hpp"
#include "tests/config_path.hpp"
#include "tests/formats/record_fields.hpp"

namespace halfspace::tests {
namespace {

class FilmFrame : public testing::Test {
 protected:
  template <class F>
  static void activate() {
    const Config config = model::find_configuration(config_path("film_tiny")).config();
    F::activate(config, format_table(config));
  }
  template <class F>
  static Frame<F> frame(int width, int height) {
    Frame<F> out{};
    out.width = from_raw<typename F::X>(width), out.height = from_raw<typename F::Y>(height);
    return out;
  }
  int below(int n) { return int(bits_() % unsigned(n)); }

  std::mt19937_64 bits_{5};
};

// Frames of all sizes but the smallest; the largest too, which takes every turn that a loop has.
constexpr int kSizes[][2] = {{1, 1}, {3, 2}, {5, 7}, {8, 8}, {0, 0}};

TEST_F(FilmFrame, OfStoredPixelsIsItsStamps) {
  using F = RuntimeFormats<Stamp4>;
  activate<F>();
  FaceTable<F> faces;
  for (int n = 0; n < F::kTriangles; ++n) faces.face[n] = from_raw<F::Face>(n + 1);
  for (const auto& size : kSizes) {
    const int width = size[0] ? size[0] : F::kWidth, height = size[1] ? size[1] : F::kHeight;
    Stream<Scan<F>> scan_one, scan_whole;
    Stream<Pixel<F>> pixel_one, pixel_whole;
    Stream<ShownPixel<F>> one, whole;
    const int columns = stamps_for(width, F::kLanesX), stamps = columns * stamps_for(height, F::kLanesY);
    for (int n = 0; n < stamps; ++n) {
      Scan<F> scan{};
      Pixel<F> pixel{};
      pixel.visit(Randomize{bits_});
      scan.x = from_raw<F::X>(n % columns), scan.y = from_raw<F::Y>(n / columns);
      scan.last = from_raw<Bit>(n + 1 == stamps);
      for (auto& index : scan.index) index = from_raw<F::Index>(below(std::min(F::kTriangles, 6) + 1));
      scan_one.write(scan), scan_whole.write(scan);
      pixel_one.write(pixel), pixel_whole.write(pixel);
    }
    const auto registers = frame<F>(width, height);
    for (int n = 0; n < stamps; ++n) {
      EXPECT_EQ(pixel_store(registers, scan_one, pixel_one, faces, one), n + 1 == stamps);
    }
    pixel_store_frame(registers, scan_whole, pixel_whole, faces, whole);
    EXPECT_TRUE(scan_whole.empty() && pixel_whole.empty());
    const std::vector<std::int64_t> shown = drain(one);
    Fields of_a_word;
    ShownPixel<F>{}.visit(of_a_word);
    EXPECT_EQ(shown.size(), of_a_word.values.size() * std::size_t(width * height));
    EXPECT_EQ(drain(whole), shown);
  }
}

TEST_F(FilmFrame, OfMotionComesInTheOrderOfTiles) {
  using F = RuntimeFormats<Stamp4>;
  activate<F>();
  MotionBuffer<F> buffer;
  for (const auto& size : kSizes) {
    const int width = size[0] ? size[0] : F::kWidth, height = size[1] ? size[1] : F::kHeight;
    for (const int every : {1, 3}) {
      Stream<Motion<F>> motion, ordered;
      std::vector<int> expected;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          Motion<F> word{};
          word.visit(Randomize{bits_});
          word.x = from_raw<F::X>(x), word.y = from_raw<F::Y>(y);
          word.face = from_raw<F::Face>((x + y) % every == 0);
          word.last = from_raw<Bit>(y + 1 == height && x + 1 == width);
          motion.write(word);
        }
      }
      for (TilePlace at; at.y < height; at = next_in_tiles(at, width, height)) {
        if ((at.x + at.y) % every == 0) expected.push_back(at.y * width + at.x);
      }
      motion_order_frame(frame<F>(width, height), motion, buffer, ordered);
      EXPECT_TRUE(motion.empty());
      std::vector<int> got;
      while (!ordered.empty()) {
        const Motion<F> word = ordered.read();
        got.push_back(int(raw(word.y)) * width + int(raw(word.x)));
        EXPECT_EQ(is_set(word.last), ordered.empty());
      }
      EXPECT_EQ(got, expected) << width << "x" << height;
      for (int n = 0; n < F::kWidth * F::kHeight; ++n) EXPECT_FALSE(is_set(buffer.word[n].face)) << n;
    }
  }
}

template <class F>
void find_holes(std::mt19937_64& bits, int width, int height) {
  Stream<Motion<F>> motion_one, motion_whole;
  Stream<Compensated<F>> made_one, made_whole;
  Stream<Asked<F>> one, whole;
  FilmBuffer<F> film_one, film_whole;
  HoleMarks<F> marks_one, marks_whole;
  for (int n = 0; n < width * height; ++n) {
    Motion<F> motion{};
    Compensated<F> made{};
    made.visit(Randomize{bits});
    motion.face = from_raw<typename F::Face>(bits() % 3);
    made.last = motion.last = from_raw<Bit>(n + 1 == width * height);
    made.x = motion.x = from_raw<typename F::X>(n % width);
    made.y = motion.y = from_raw<typename F::Y>(n / width);
    made.keys = from_raw<Keys>(bits() % 2 ? bits() : 0);
    motion_one.write(motion), motion_whole.write(motion);
    made_one.write(made), made_whole.write(made);
  }
  typename F::Face held = from_raw<typename F::Face>(0);
  for (int n = 0; n < width * height; ++n) hole_find(motion_one, made_one, film_one, marks_one, held, one);
  hole_find_frame(motion_whole, made_whole, film_whole, marks_whole, whole);
  EXPECT_TRUE(motion_whole.empty() && made_whole.empty());
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(drain(whole), drain(one));
  for (int n = 0; n < F::kStamps; ++n) {
    for (int l = 0; l < F::kLanes; ++l) {
      EXPECT_EQ(is_set(Bit(marks_whole.hole[n][l])), is_set(Bit(marks_one.hole[n][l])));
    }
  }
}
TEST_F(FilmFrame, OfHolesIsItsWords) {
  using F = RuntimeFormats<Stamp4>;
  activate<F>();
  for (const auto& size : kSizes) {
    find_holes<F>(bits_, size[0] ? size[0] : F::kWidth, size[1] ? size[1] : F::kHeight);
  }
}

}  // namespace
}  // namespace halfspace::tests
