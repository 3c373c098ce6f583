// SPDX-License-Identifier: Apache-2.0
// Frames between keys against what they are worked out to be by hand, and against the rendered ones.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "ref/error.hpp"
#include "tests/motion/ref/squares.hpp"

namespace halfspace::ref {
namespace {

TEST(Compensate, AStillSceneIsItself) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    for (const bool textured : {false, true}) {
      const At still = [&](double) { return load_scene(name, 0.7, {textured}); };
      UpConversion mode = kPlain;
      if (textured) mode.texture = TextureMode{};
      for (const Filter filter : kFilters) {
        mode.compensation.filter = filter;
        mode.mapping = filter == Filter::kArea ? VectorMapping::kPerspective : VectorMapping::kLinear;
        mode.relight = filter == Filter::kBicubic;
        mode.surfaces = filter == Filter::kNearest;
        mode.method = filter == Filter::kBilinear ? MotionMethod::kStraight : MotionMethod::kExact;
        const FrameBetween made = between(still, 0.4, mode);
        EXPECT_EQ(made.colour, made.rendered) << name_of(filter);
        EXPECT_EQ(made.shares.filled + made.shares.copied, 0u);
        EXPECT_GT(made.shares.blended, 500u);
      }
    }
  }
}

TEST(Compensate, ASquareMovedByWholePixelsIsItself) {
  const At moved = [](double a) { return squares({{20 + 10 * a, 30 - 20 * a, 50, 40}}, noise(16)); };
  UpConversion mode = kPlain;
  mode.texture = TextureMode{};
  for (const Filter filter : kFilters) {
    const FrameBetween made = between(moved, 0.5, with(filter, mode));
    EXPECT_EQ(made.colour, made.rendered) << name_of(filter);
    EXPECT_EQ(made.shares.blended, 50u * 40 + 1);
    EXPECT_EQ(made.shares.background, std::uint64_t(kWidth * kHeight - 50 * 40 - 1));
  }
  // By half a pixel it is not: the texture is resampled.
  EXPECT_GT(largest_difference(between(moved, 0.55, with(Filter::kBilinear, mode)).colour,
                               between(moved, 0.55, with(Filter::kBilinear, mode)).rendered),
            10);
  mode.field = FieldSize::kHalf;  // from an even pixel to even pixels
  const FrameBetween half = between(
      [](double a) {
        return squares({{20 + 12 * a, 30 - 20 * a, 50, 40}}, noise(16));
      },
      0.5, with(Filter::kBilinear, surfaces(mode)));
  int others = 0;
  for (std::size_t i = 0; i < half.colour.size(); ++i) others += half.colour[i] != half.rendered[i];
  EXPECT_LE(others, 4);  // around the corner's pixel
}

// What a vector for 2 × 2 pixels says of the light it says of all four.
TEST(Compensate, HalfAFieldIsRelitAsWell) {
  const At scene = [](double a) {
    Scene scene = load_scene("castle");
    scene.ambient = glm::dvec3(0.2 + 0.5 * a);
    return scene;
  };
  UpConversion mode = kPlain;
  mode.field = FieldSize::kHalf;
  const auto far_off = [&] {
    const FrameBetween made = between(scene, 0.3, mode);
    int pixels = 0;
    for (std::size_t i = 0; i < made.colour.size(); ++i)
      pixels += std::abs(made.colour[i][1] - made.rendered[i][1]) > 6;
    return pixels;
  };
  mode.compensation.use[1] = false;
  const int dark = far_off();
  mode.relight = true;
  EXPECT_LT(far_off(), dark / 4);
}

TEST(Compensate, BlendsByTime) {
  // From (100, 60, 20) to (200, 61, 0).
  const At scene = [](double a) {
    return squares({{20, 30, 50, 40, 0, glm::mix(glm::dvec3(100, 60, 20), glm::dvec3(200, 61, 0), a) / 255.0}});
  };
  UpConversion mode = kPlain;
  const auto at = [&](double a) { return between(scene, a, mode).colour[50 * kWidth + 40]; };
  EXPECT_EQ(at(0.25), (std::array<std::uint8_t, 4>{125, 60, 15, 255}));
  EXPECT_EQ(at(0.5), (std::array<std::uint8_t, 4>{150, 61, 10, 255}));  // 60.5 goes up
  EXPECT_EQ(at(0.75), (std::array<std::uint8_t, 4>{175, 61, 5, 255}));
  mode.compensation.use[0] = false;
  EXPECT_EQ(at(0.25), (std::array<std::uint8_t, 4>{200, 61, 0, 255}));
  const Colours first{{100, 60, 20, 255}}, second{{201, 61, 0, 255}};
  EXPECT_EQ(temporal_average(first, second)[0], (std::array<std::uint8_t, 4>{151, 61, 10, 255}));
  EXPECT_EQ(repeated(first, second, 0.5), first);
  EXPECT_EQ(repeated(first, second, 0.6), second);
}

TEST(Compensate, EdgesBetweenPixelsBySamples) {
  const At moved = [](double a) { return squares({{20 + 11 * a, 30, 50, 40}}); };  // keys on pixels, 25.5 between
  UpConversion mode = surfaces(kPlain);
  mode.samples = 4;
  const FrameBetween made = between(moved, 0.5, with(Filter::kBilinear, mode));
  EXPECT_EQ(made.colour, made.rendered);
  EXPECT_EQ(made.shares.filled, 0u);
  const auto &out = made.colour[50 * kWidth + 24], &edge = made.colour[50 * kWidth + 25],
             &in = made.colour[50 * kWidth + 26];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(edge[c], (out[c] + in[c]) / 2.0, 1);
  EXPECT_GT(std::abs(in[0] - out[0]), 100);
  mode.field = FieldSize::kPixels;  // all or nothing
  EXPECT_GT(largest_difference(between(moved, 0.5, with(Filter::kBilinear, mode)).colour, made.rendered), 50);
}

// A strip of half a pixel over a square, a quarter of a pixel in either of two columns. Without mixed pixels neither it
// has a key nor the square between the centres of these columns; by the face of most samples the square has; by two
// both have, and their own colours.
TEST(Compensate, EdgesOfKeysKeepTheirFaces) {
  const At moved = [](double a) {
    return squares({{20 + 8 * a, 30, 50, 40, 0, {1, 0, 0}}, {40.75 + 8 * a, 30, 0.5, 40, 1, {0, 0, 1}}});
  };
  UpConversion mode = surfaces(kPlain);
  mode.samples = 4;
  const auto made = [&](KeyFaces faces) {
    mode.key_faces = faces;
    return between(moved, 0.5, with(Filter::kBilinear, mode));
  };
  const FrameBetween pure = made(KeyFaces::kPure), most = made(KeyFaces::kMost), two = made(KeyFaces::kTwo);
  EXPECT_EQ(pure.shares.filled, 2u * 160 + 2u * 160);
  EXPECT_EQ(pure.shares.rendered, 2u * 40);
  EXPECT_EQ(most.shares.filled, 2u * 160);
  EXPECT_EQ(two.shares.filled, 0u);
  EXPECT_EQ(two.shares.rendered, 0u);
  EXPECT_EQ(two.colour, two.rendered);
  EXPECT_EQ(two.rendered, pure.rendered);
}

// Keys of a pixel a sample have no mixed pixels, and those finer than the frame no more colours to lend.
TEST(Compensate, FinerKeysAreNearer) {
  const At moved = [](double a) { return squares({{20 + 7.3 * a, 30 + 1.9 * a, 50, 40}}, noise(16)); };
  UpConversion mode = surfaces(kPlain);
  mode.texture = TextureMode{};
  for (const int samples : {1, 2}) {
    mode.samples = samples;
    double last = 0;
    for (const int scale : {1, 2, 4}) {
      mode.key_scale = scale;
      const FrameBetween made = between(moved, 0.5, with(Filter::kBilinear, mode));
      const double psnr = quality(made.colour, made.rendered, kWidth, kHeight).psnr_y;
      EXPECT_GT(psnr, last + 2) << samples << " samples, scale " << scale;
      last = psnr;
    }
  }
  mode.samples = 4, mode.key_scale = 3;
  EXPECT_THROW(between(moved, 0.5, mode), Error);
  mode.key_scale = 2, mode.field = FieldSize::kHalf;
  EXPECT_THROW(between(moved, 0.5, mode), Error);
}

// A key that shows a square three times as large, and a vector a pixel: a bilinear filter takes one pixel of nine.
TEST(Compensate, AFootprintTakesAllThatItsPixelIsInTheKey) {
  const At shrinks = [](double a) {
    return squares({{5 + 55 * a, 5 + 40 * a, 150 - 100 * a, 105 - 70 * a}}, noise(64));
  };
  UpConversion mode = surfaces(kPlain);
  mode.texture = TextureMode{};
  mode.samples = 4, mode.field = FieldSize::kPixels;
  mode.compensation.use[1] = false;
  const auto psnr = [&](Filter filter) {
    const FrameBetween made = between(shrinks, 1, with(filter, mode));
    return quality(made.colour, made.rendered, kWidth, kHeight).psnr_y;
  };
  EXPECT_GT(psnr(Filter::kFootprint), psnr(Filter::kBilinear) + 3);
  // Where nothing is larger it is the bilinear filter.
  const At moved = [](double a) { return squares({{20 + 7.3 * a, 30, 50, 40}}, noise(16)); };
  EXPECT_EQ(between(moved, 0.5, with(Filter::kFootprint, mode)).colour,
            between(moved, 0.5, with(Filter::kBilinear, mode)).colour);
}

// What no key shows, untested, is what lies there.
TEST(Compensate, HolesMayBeWhatLiesThere) {
  const At uncovers = [](double a) {
    return squares({{20, 30, 50, 40, 0, {1, 0, 0}}, {50 - 60 * std::abs(a - 0.5), 30, 50, 40, 1, {0, 0, 1}}});
  };
  UpConversion mode = surfaces(kPlain);
  const FrameBetween rendered = between(uncovers, 0.5, mode);
  mode.compensation.render_holes = false;
  const FrameBetween untested = between(uncovers, 0.5, mode);
  EXPECT_EQ(rendered.shares.filled, 30u * 40);
  EXPECT_EQ(rendered.colour, rendered.rendered);
  EXPECT_EQ(untested.shares.filled, 0u);
  EXPECT_EQ(untested.colour[50 * kWidth + 30][2], 255);  // of the blue one, which hides the red one in both keys
  EXPECT_EQ(untested.rendered[50 * kWidth + 30][2], 0);
}

}  // namespace
}  // namespace halfspace::ref
