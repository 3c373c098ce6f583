// SPDX-License-Identifier: Apache-2.0
// motion_compensate against its definition (study/bounds/compensation_exact.hpp): filters, matches, edges, caches, and
// the bounds of its weights.
#include <gtest/gtest.h>

#include <cstdio>

#include "ref/error.hpp"
#include "study/bounds/compensation_exact.hpp"
#include "tests/config_path.hpp"
#include "vectors/frames/compensation_frames.hpp"

namespace halfspace::tests {
namespace {

using model::CompensatedFrame;
using model::CompensatedPixel;
using model::CompensationModel;
using model::Compensator;
using model::exact_weights;
using model::KeyFrame;
using model::NamedCompensation;
using model::RawMotion;

constexpr KeyFilter kFilters[] = {KeyFilter::kNearest, KeyFilter::kBilinear, KeyFilter::kArea, KeyFilter::kBicubic};

const char* name_of(KeyFilter filter) {
  return filter == KeyFilter::kNearest    ? "nearest"
         : filter == KeyFilter::kBilinear ? "bilinear"
         : filter == KeyFilter::kArea     ? "area"
                                          : "bicubic";
}

Config base(const char* name) { return model::find_configuration(config_path(std::string("motion_") + name)).config(); }
Config with(KeyFilter filter, int fraction, int weight_bits, int samples, int relight) {
  Config c = base("middle");
  c.filter = filter;
  c.vector_fraction = fraction, c.weight_bits = weight_bits, c.samples = samples;
  c.relight = relight;
  if (!relight) c.colour_fraction = 0;
  return c;
}

Compensator compensator(const Config& config) { return Compensator(model::Configuration("test", config)); }

// Every word of a frame, and the misses.
void expect_model(const Config& config, const NamedCompensation& frame, std::array<std::size_t, 4>& kinds) {
  const CompensationModel model(config, false);
  const model::CompensationInput input = frame.input();
  const CompensatedFrame got = compensator(config).run(input);
  std::vector<RawMotion> order = frame.motion;
  model::order_by_tiles(order, config);
  ASSERT_EQ(got.pixels.size(), std::max<std::size_t>(order.size(), 1));
  for (std::size_t n = 0; n < order.size(); ++n) {
    const CompensationModel::Pixel want = model.pixel(input, order[n]);
    ASSERT_EQ(got.pixels[n].x, order[n].x);
    ASSERT_EQ(got.pixels[n].y, order[n].y);
    ASSERT_EQ(got.pixels[n].keys, want.keys) << frame.note << ", " << name_of(config.filter) << ", word " << n;
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_EQ(int(got.pixels[n].rgb[c]), int(model.displayed(want.value[c])))
          << frame.note << ", " << name_of(config.filter) << ", word " << n << ", channel " << c << ", keys "
          << want.keys;
    }
    ++kinds[std::size_t(want.keys)];
  }
}

TEST(Compensation, IsItsDefinition) {
  for (const KeyFilter filter : kFilters) {
    std::array<std::size_t, 4> kinds{};
    for (const char* name : {"low", "middle", "high"}) {
      for (const int samples : {1, 2, 4}) {
        Config config = base(name);
        config.filter = filter, config.samples = samples;
        for (const NamedCompensation& frame : model::compensation_frames(config, 7)) expect_model(config, frame, kinds);
      }
    }
    std::printf("%-8s holes %zu, of key 0 alone %zu, of key 1 alone %zu, of both %zu\n", name_of(filter), kinds[0],
                kinds[1], kinds[2], kinds[3]);
    for (const std::size_t count : kinds) EXPECT_GT(count, 300u);
  }
}

// A key frame of one face, whose pixels are all different.
KeyFrame smooth_key(int width, int height, std::uint32_t face, int step) {
  KeyFrame key;
  key.width = width, key.height = height;
  for (int n = 0; n < width * height; ++n) {
    key.rgb.push_back({std::uint8_t(n * step), std::uint8_t(n * 7 + step), std::uint8_t(n / width * 5 + n)});
    key.face.push_back(face);
  }
  return key;
}

RawMotion still(int x, int y, std::uint32_t face) {
  RawMotion m;
  m.x = x, m.y = y, m.face = face;
  m.key[0].there = m.key[1].there = true;
  return m;
}

TEST(Compensation, CopiesWhereWholePixelsMove) {
  for (const KeyFilter filter : kFilters) {
    for (const int relight : {0, 1}) {
      const Config config = with(filter, 4, 5, 1, relight);
      NamedCompensation frame;
      frame.width = 21, frame.height = 17;
      frame.key = {smooth_key(21, 17, 3, 11), smooth_key(21, 17, 3, 11)};
      frame.weight = 13;
      for (int y = 0; y < 17; ++y) {
        for (int x = 0; x < 21; ++x) {
          frame.motion.push_back(still(x, y, 3));
          frame.motion.back().key[0].x = frame.motion.back().key[1].x = (x % 5 - 2) * 16;
          frame.motion.back().key[0].y = frame.motion.back().key[1].y = (y % 3 - 1) * 16;
        }
      }
      for (const CompensatedPixel& p : compensator(config).run(frame.input()).pixels) {
        const int x = p.x + p.x % 5 - 2, y = p.y + p.y % 3 - 1;
        const bool inside = x >= 0 && x < 21 && y >= 0 && y < 17;
        ASSERT_EQ(p.keys, inside ? 3 : 0) << name_of(filter) << " at " << p.x << ", " << p.y;
        if (!inside) continue;
        ASSERT_EQ(p.rgb, frame.key[0].rgb[std::size_t(y) * 21 + x]) << name_of(filter) << " at " << p.x << ", " << p.y;
      }
    }
  }
}

// All patterns of four pixels that match, at every fraction; what stands for the others is one of those with the
// largest weight.
TEST(Compensation, GivesTheWeightOfOthersToTheLargest) {
  for (const KeyFilter filter : {KeyFilter::kBilinear, KeyFilter::kArea, KeyFilter::kBicubic}) {
    const Config config = with(filter, 3, 6, 1, 0);
    const CompensationModel model(config, false);
    std::size_t compared = 0;
    for (int pattern = 0; pattern < 16; ++pattern) {
      NamedCompensation frame;
      frame.width = frame.height = 8;
      frame.key[0] = frame.key[1] = smooth_key(8, 8, 9, 3);
      for (int n = 0; n < 4; ++n) {
        const std::size_t at = std::size_t(8 * (3 + n / 2) + 3 + n % 2);
        frame.key[0].rgb[at] = {std::uint8_t(60 * n), std::uint8_t(255 - 60 * n), std::uint8_t(1 << (2 * n))};
        if (!(pattern >> n & 1)) frame.key[0].face[at] = 8;
      }
      frame.weight = 64;
      for (int v = 0; v < 8; ++v) {
        for (int u = 0; u < 8; ++u) {
          RawMotion m = still(3, 3, 9);
          m.key[0].x = u, m.key[0].y = v;
          m.key[1].there = false;
          frame.motion = {m};
          const CompensatedFrame got = compensator(config).run(frame.input());
          const CompensationModel::Pixel want = model.pixel(frame.input(), m);
          ASSERT_EQ(got.pixels[0].keys, want.keys);
          // On the centre of pixel 0 that one alone has a weight, on its row or column two.
          const int weighted = (u ? 3 : 1) * (v ? 5 : 1) & 15;
          ASSERT_EQ(want.keys, (pattern & weighted) != 0)
              << name_of(filter) << ", pattern " << pattern << ", at " << u << ", " << v;
          for (std::size_t c = 0; c < 3; ++c) {
            ASSERT_EQ(int(got.pixels[0].rgb[c]), int(model.displayed(want.value[c])))
                << name_of(filter) << ", pattern " << pattern << ", at " << u << "/8, " << v << "/8";
          }
          ++compared;
        }
      }
    }
    EXPECT_EQ(compared, 16u * 64u);
  }
  // Weights of ¾·¾ … ¼·¼ of a place nearest to pixel 0: with it missing, the column's neighbour where y is nearer to
  // the middle.
  const bool but_nearest[4] = {false, true, true, true}, opposite[4] = {false, false, false, true};
  EXPECT_EQ(standing_tap(but_nearest, 2, 3, 3), 2);
  EXPECT_EQ(standing_tap(but_nearest, 3, 2, 3), 1);
  EXPECT_EQ(standing_tap(but_nearest, 3, 3, 3), 1);
  EXPECT_EQ(standing_tap(opposite, 1, 1, 3), 3);
}

TEST(Compensation, ClampsWhatRelightingAdds) {
  const Config config = with(KeyFilter::kBilinear, 5, 6, 1, 1);
  for (const auto& [colour, difference, want] : {std::array<int, 3>{200, 255, 255},
                                                 {255, -255, 0},
                                                 {10, -11, 0},
                                                 {10, -10, 0},
                                                 {250, 5, 255},
                                                 {250, 6, 255},
                                                 {100, 20, 120}}) {
    NamedCompensation frame;
    frame.width = frame.height = 4;
    KeyFrame key = smooth_key(4, 4, 1, 1);
    for (auto& rgb : key.rgb) rgb.fill(std::uint8_t(colour));
    frame.key = {key, key};
    frame.weight = 20;
    frame.motion = {still(1, 2, 1)};
    frame.motion[0].key[0].x = 9;
    for (auto& v : frame.motion[0].key) v.difference.fill(difference * (1 << kDifferenceFraction));
    const CompensatedPixel got = compensator(config).run(frame.input()).pixels[0];
    EXPECT_EQ(got.rgb, (std::array<std::uint8_t, 3>{std::uint8_t(want), std::uint8_t(want), std::uint8_t(want)}))
        << colour << difference;
  }
}

// Neighbours move alike, so that a cache is of use; a word in twelve goes anywhere.
TEST(KeyCache, MissesAreThoseOfFourTiles) {
  std::size_t total = 0, least = 0;
  for (const KeyFilter filter : kFilters) {
    for (const int samples : {1, 4}) {
      const Config config = with(filter, 5, 6, samples, 0);
      NamedCompensation frame;
      frame.width = 61 * samples, frame.height = 43 * samples;
      frame.key = {smooth_key(61, 43, 2, 3), smooth_key(61, 43, 2, 5)};
      for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
          RawMotion m = still(x, y, (x + y) % 31 == 0 ? 0 : 2);
          const int far = (x * 7 + y * 13) % 12 == 0 ? 6 : 1;
          m.key[0].x = 32 * 5 * samples * far + x % 3, m.key[0].y = -32 * 3 * samples;
          m.key[1].x = -70, m.key[1].y = 19 * far;
          m.key[1].there = x % 17 != 0;
          frame.motion.push_back(m);
        }
      }
      const CompensatedFrame got = compensator(config).run(frame.input());
      const CompensationModel model(config, false);
      for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(got.misses[std::size_t(k)], model.misses(frame.input(), got.pixels, k))
            << name_of(filter) << ", key " << k;
      }
      EXPECT_GE(got.fills, std::max(got.misses[0], got.misses[1]));
      EXPECT_LE(got.fills, got.misses[0] + got.misses[1]);
      total += got.misses[0] + got.misses[1], least += 48 * 2;
      std::array<std::size_t, 4> kinds{};
      expect_model(config, frame, kinds);
    }
  }
  EXPECT_GT(total, least) << "every tile is fetched once at least";
}

// Nearest places of the same tile: a word goes through without a fetch.
TEST(KeyCache, HoldsFourTiles) {
  for (const KeyFilter filter : kFilters) {
    const Config config = with(filter, 5, 6, 1, 0);
    const NamedCompensation frame = model::warm_frame(config, 2000, 3);
    const CompensatedFrame got = compensator(config).run(frame.input());
    EXPECT_LE(got.misses[0], 4u);
    EXPECT_LE(got.misses[1], 4u);
    EXPECT_GT(got.misses[0], 1u);
  }
}

double at_t(int n, int g) { return std::ldexp(n, -g); }

TEST(Weights, SumToOneAndAreRounded) {
  for (const KeyFilter filter : {KeyFilter::kBilinear, KeyFilter::kArea, KeyFilter::kBicubic}) {
    for (int g = 1; g <= 10; ++g) {
      for (int w = 2; w <= 8; ++w) {
        ASSERT_TRUE(weights_fit(filter, g, w)) << name_of(filter) << ", g " << g << ", w " << w;
        for (int n = 0; n < 1 << g; ++n) {
          const AxisWeights got = axis_weights(filter, n, g, w);
          const std::array<double, 4> exact = exact_weights(filter, at_t(n, g));
          const std::size_t largest = std::size_t(std::max_element(exact.begin(), exact.end()) - exact.begin());
          int sum = 0;
          for (std::size_t i = 0; i < 4; ++i) {
            sum += got.tap[i];
            if (i == largest) continue;
            ASSERT_EQ(got.tap[i], int(std::floor(std::ldexp(exact[i], w) + 0.5)))
                << name_of(filter) << " " << n << "/2^" << g;
          }
          ASSERT_EQ(sum, 1 << w);
          if (filter == KeyFilter::kBilinear && w >= g) {
            ASSERT_EQ(got.tap[2], n << (w - g));
          }
        }
      }
    }
  }
}

// The largest error of a key before rounding, in LSB: of all fractions, with the worst colours for each.
struct Worst {
  double error = 0;
  int x = 0, y = 0;
  bool above = false;
};
Worst worst_colours(const Config& c) {
  const int g = c.vector_fraction + exact_log2(c.samples);
  Worst worst;
  for (int v = 0; v < 1 << g; ++v) {
    for (int u = 0; u < 1 << g; ++u) {
      const AxisWeights columns = axis_weights(c.filter, u, g, c.weight_bits),
                        rows = axis_weights(c.filter, v, g, c.weight_bits);
      const std::array<double, 4> x = exact_weights(c.filter, at_t(u, g)), y = exact_weights(c.filter, at_t(v, g));
      double above = 0, below = 0;
      for (std::size_t n = 0; n < 16; ++n) {
        const std::size_t i = n % 4, j = n / 4;
        const double error = std::ldexp(double(columns.tap[i]) * rows.tap[j], -2 * c.weight_bits) - x[i] * y[j];
        (error > 0 ? above : below) += std::fabs(error);
      }
      const double error = std::max(above, below) * ((1 << c.colour_bits) - 1);
      if (error > worst.error) worst = {error, u, v, above > below};
    }
  }
  return worst;
}

// docs/numerics.md: what the weights' own bits cost. The worst colours are drawn, and the kernel is off by that much.
TEST(Weights, CostNoMoreThanTheirBound) {
  for (const KeyFilter filter : {KeyFilter::kBilinear, KeyFilter::kArea, KeyFilter::kBicubic}) {
    for (int w = 2; w <= 8; ++w) {
      const Config config = with(filter, 6, w, 1, 1);
      const double full = 255, bound = full * std::ldexp(filter == KeyFilter::kBicubic ? 4 : 1, -w);
      const Worst worst = worst_colours(config);
      const bool is_exact = filter == KeyFilter::kBilinear && w >= 6;
      EXPECT_LE(worst.error, is_exact ? 1e-9 : bound);
      if (!is_exact) {
        EXPECT_GT(worst.error, bound * (filter == KeyFilter::kBicubic ? 0.3 : 0.6)) << name_of(filter) << ", w " << w;
      }
      // These colours, and the difference that keeps them within the range of a colour.
      NamedCompensation frame;
      frame.width = frame.height = 8;
      KeyFrame key = smooth_key(8, 8, 1, 1);
      const AxisWeights columns = axis_weights(filter, worst.x, 6, w), rows = axis_weights(filter, worst.y, 6, w);
      const std::array<double, 4> x = exact_weights(filter, at_t(worst.x, 6)),
                                  y = exact_weights(filter, at_t(worst.y, 6));
      for (std::size_t n = 0; n < 16; ++n) {
        const std::size_t i = n % 4, j = n / 4;
        const double error = std::ldexp(double(columns.tap[i]) * rows.tap[j], -2 * w) - x[i] * y[j];
        key.rgb[8 * (2 + j) + 2 + i].fill((error > 0) == worst.above ? 255 : 0);
      }
      frame.key = {key, key};
      frame.weight = 1 << w;
      frame.motion = {still(3, 3, 1)};
      frame.motion[0].key[0].x = worst.x, frame.motion[0].key[0].y = worst.y;
      const CompensationModel::Pixel exact = CompensationModel(config, true).pixel(frame.input(), frame.motion[0]);
      const int shift = 100 - int(std::lround(exact.value[0]));
      for (auto& v : frame.motion[0].key) v.difference.fill(shift * (1 << kDifferenceFraction));
      const double got = compensator(config).run(frame.input()).pixels[0].rgb[0];
      EXPECT_LE(std::fabs(got - shift - exact.value[0]), worst.error + 0.5);
      EXPECT_GE(std::fabs(got - shift - exact.value[0]), worst.error - 0.5);
      std::printf("%-8s w = %d: %8.4f LSB of %8.4f\n", name_of(filter), w, worst.error, bound);
    }
  }
}

TEST(Compensator, RefusesWhatDoesNotFit) {
  const Config config = with(KeyFilter::kBilinear, 5, 6, 2, 0);
  NamedCompensation frame = model::warm_frame(config, 10, 1);
  EXPECT_NO_THROW(compensator(config).run(frame.input()));
  frame.weight = 65;
  EXPECT_THROW(compensator(config).run(frame.input()), ref::Error);
  frame.weight = 64;
  frame.width += 2;
  EXPECT_THROW(compensator(config).run(frame.input()), ref::Error);
  EXPECT_THROW(Compensator(model::find_configuration("middle")), ref::Error);
}

}  // namespace
}  // namespace halfspace::tests
