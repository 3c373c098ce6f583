// SPDX-License-Identifier: Apache-2.0
// Texture in the kernels: the reciprocal of a pixel, the product with a colour, and where a pixel lies among texels
// against its bound.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "model/formats/runtime_formats.hpp"
#include "ref/error.hpp"
#include "ref/geometry/plane.hpp"
#include "study/proofs/texture_bounds.hpp"
#include "tests/config_path.hpp"
#include "tests/texture/texture_kernels.hpp"
#include "tests/texture/textured_configs.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

// |y·m − 1| of every field, with all and with none of the bits that are cut.
template <class C>
void expect_reciprocal_within_bound() {
  using F = Formats<C, Stamp1>;
  const int b = F::Coordinate::width(), field_bits = kInverseIndexBits + kInverseOffsetBits;
  const std::int64_t cut = b - 1 > field_bits ? std::int64_t(1) << (b - 1 - field_bits) : 1;
  double largest = 0;
  for (std::int64_t first = std::int64_t(1) << (b - 1); first < std::int64_t(1) << b; first += cut) {
    for (const std::int64_t q : {first, first + cut - 1}) {
      const auto got = reciprocal_lookup<F>(from_raw<typename F::Coordinate>(q));
      ASSERT_EQ(int(raw(got.shift)), 0);
      const double m = std::ldexp(double(q), 1 - b), y = std::ldexp(double(raw(got.inverse)), -kInverseFraction);
      largest = std::max(largest, std::fabs(y * m - 1));
      ASSERT_LT(std::fabs(y * m - 1), model::kInverseError) << q;
    }
  }
  std::printf("%-16s reciprocal: |y m - 1| <= 2^%.3f\n", C::config().name, std::log2(largest));
  EXPECT_GT(largest, model::kInverseError / 2) << "the bound is loose";
  for (int k = 0; k < b; ++k) {
    const auto got = reciprocal_lookup<F>(from_raw<typename F::Coordinate>((std::int64_t(1) << (b - k)) - 1));
    EXPECT_EQ(int(raw(got.shift)), k);
  }
}
TEST(ReciprocalLookup, IsWithinTheBound) {
  expect_reciprocal_within_bound<TexturedMiddle>();
  expect_reciprocal_within_bound<TexturedFlat>();
}

template <int Bits>
struct Coloured {
  static constexpr Config config() {
    Config config = TexturedLow::config();
    config.colour_bits = Bits;
    return config;
  }
};

// Of every colour and texel without fraction it is rounded right; with one it is off by what is said at textured().
template <int Bits>
void expect_products() {
  using F = Formats<Coloured<Bits>, Stamp1>;
  const int full = (1 << Bits) - 1, one = 1 << kFilteredFraction;
  double largest = 0;
  for (int lit = 0; lit <= full; ++lit) {
    for (int texel = 0; texel <= full * one; ++texel) {
      const int got = int(raw(textured<F>(from_raw<typename F::Colour>(lit), from_raw<typename F::Filtered>(texel))));
      if (texel % one == 0) {
        ASSERT_EQ(got, (2 * lit * texel / one + full) / (2 * full)) << lit << " times " << texel / one;
      }
      const double error = std::fabs(got - double(lit) * texel / one / full) - 0.5;
      ASSERT_LE(error, std::ldexp(1.0, -Bits - 1) + std::ldexp(1.0, -Bits - 8)) << lit << " times " << texel;
      largest = std::max(largest, error);
    }
  }
  EXPECT_GT(largest, 0);
}
TEST(Product, IsRounded) {
  expect_products<1>();
  expect_products<2>();
  expect_products<5>();
  expect_products<6>();
  expect_products<7>();
  expect_products<8>();
}

// The pixels that a triangle covers, or some of them, with the weights of its vertices in their own order, times the
// area.
template <class Visit>
void for_covered(const ref::SnappedTriangle& in, int width, int height, int f, Visit visit) {
  const ref::OrderedTriangle exact(in);
  const int one = 1 << f;
  auto [left, right] = std::minmax({in.x[0], in.x[1], in.x[2]});
  auto [top, bottom] = std::minmax({in.y[0], in.y[1], in.y[2]});
  const int x0 = std::max(left / one - 1, 0), x1 = std::min(right / one + 1, width - 1);
  const int y0 = std::max(top / one - 1, 0), y1 = std::min(bottom / one + 1, height - 1);
  for (int y = y0; y <= y1; y += std::max(1, (y1 - y0) / 40)) {
    for (int x = x0; x <= x1; x += std::max(1, (x1 - x0) / 40)) {
      const std::int64_t px = std::int64_t(x) * one + one / 2, py = std::int64_t(y) * one + one / 2;
      std::array<std::int64_t, 3> weight{};
      bool inside = true;
      for (int i = 0; i < 3; ++i) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        const std::int64_t w =
            (exact.x[b] - exact.x[a]) * (py - exact.y[a]) - (exact.y[b] - exact.y[a]) * (px - exact.x[a]);
        weight[std::size_t(exact.vertex[i])] = w;
        inside = inside && w >= 0;
      }
      double distance = 0;  // from any vertex: which one the kernels start from is theirs
      for (int v = 0; v < 3; ++v) {
        distance = std::max(distance, double(std::llabs(px - in.x[v]) + std::llabs(py - in.y[v])) / one);
      }
      if (inside) visit(x, y, weight, distance);
    }
  }
}

// a − b modulo n, as near to 0 as it can be.
double difference(double a, double b, double n) { return std::remainder(a - b, n); }

std::vector<model::NamedFrame> frames_of(const Config& config) {
  const ref::RasterFormat format = model::raster_format(configuration_of(config));
  std::vector<model::NamedFrame> frames = model::corner_frames(format);
  for (auto& frame : model::random_frames(format, 3, 8, 80)) frames.push_back(std::move(frame));
  return frames;
}

// The place of every pixel of awkward triangles, against the exact one of the same words.
template <class C>
void expect_places_within_bound() {
  using F = Formats<C, Stamp1>;
  const Config config = C::config();
  const std::vector<model::NamedFrame> frames = frames_of(config);
  std::uint64_t compared = 0, turned = 0, first = 0;
  double share = 0;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const ref::SnappedList& scene = frames[n].scene;
    const model::TextureFrame texture = model::awkward_coordinates(scene.triangles.size(), config, n);
    const TextureKernels<F> kernels(scene, texture);
    for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
      const ref::SnappedTriangle& in = scene.triangles[k];
      const model::RawCoordinates& given = texture.triangles[k];
      const ref::OrderedTriangle exact(in);
      if (given.texture == 0 || exact.area == 0) continue;
      turned += exact.vertex[1] != (exact.vertex[0] + 1) % 3;
      first += in.y[0] > std::min(in.y[1], in.y[2]);
      const model::RawTexture& raw_texture = texture.textures[std::size_t(given.texture) - 1];
      for_covered(
          in, scene.width, scene.height, config.subpixel_bits,
          [&](int x, int y, const std::array<std::int64_t, 3>& weight, double distance) {
            const auto plane = [&](const std::array<int, 3>& values) {
              ref::Wide sum = 0;
              for (int v = 0; v < 3; ++v) sum += ref::Wide(weight[std::size_t(v)]) * values[std::size_t(v)];
              return double((long double)sum / (long double)exact.area);
            };
            const double q = has_perspective(config) ? plane(given.q) : std::ldexp(1.0, config.coordinate_bits);
            const TexturePosition<F> at = kernels.position(std::uint32_t(k) + 1, x, y);
            for (const auto& [values, place, log2_side] : {std::tuple(given.s, raw(at.u), raw_texture.log2_width),
                                                           std::tuple(given.t, raw(at.v), raw_texture.log2_height)}) {
              const double part = plane(values) / q, side = std::ldexp(1.0, log2_side),
                           span = std::ldexp(side, given.repeats);
              const double bound =
                  model::texture_place_bound(config, span, part, q, distance) + model::texture_cut_bound(config);
              const double want = part * span - (is_bilinear(config) ? 0.5 : 0);
              // What the nearest cuts off does not matter: it is half of it to either side of the middle.
              const double cut = is_bilinear(config) ? 0 : std::ldexp(0.5, -kWeightBits);
              const double error =
                  std::fabs(difference(std::ldexp(double(place), -kWeightBits) + cut, want, side)) - cut;
              if (bound < side / 2) {
                share = std::max(share, error / bound);
                ++compared;
              }
              EXPECT_LE(error, bound) << frames[n].note << ", triangle " << k + 1 << ", pixel " << x << ", " << y;
            }
          });
      if (testing::Test::HasFailure()) return;
    }
  }
  std::printf("%-16s %llu places, %.3f of the bound at most\n", config.name, static_cast<unsigned long long>(compared),
              share);
  EXPECT_GT(compared, 10000u);
  EXPECT_GT(share, 0.5) << "the frames are blind, or the bound is loose";
  EXPECT_GT(turned, 100u);
  EXPECT_GT(first, 100u);
}
TEST(TexturePlaces, AreWithinTheBound) {
  expect_places_within_bound<TexturedLow>();
  expect_places_within_bound<TexturedMiddle>();
  expect_places_within_bound<TexturedHigh>();
  expect_places_within_bound<TexturedFlat>();
  expect_places_within_bound<TexturedPhong>();
}

// All pixels of awkward frames, each with the triangle that covers it last.
template <class F>
std::vector<std::array<std::uint8_t, 4>> pictures_of(const Config& config,
                                                     const std::vector<model::NamedFrame>& frames) {
  std::vector<std::array<std::uint8_t, 4>> all;
  for (std::size_t n = 0; n < frames.size(); ++n) {
    const ref::SnappedList& scene = frames[n].scene;
    std::vector<std::uint32_t> index(std::size_t(scene.width) * scene.height);
    std::vector<std::array<std::uint8_t, 4>> lit(index.size(), {255, 255, 255, 255});
    for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
      if (ref::OrderedTriangle(scene.triangles[k]).area == 0) continue;
      for_covered(scene.triangles[k], scene.width, scene.height, config.subpixel_bits,
                  [&](int x, int y, const auto&, double) {
                    index[std::size_t(y) * scene.width + x] = std::uint32_t(k) + 1;
                    lit[std::size_t(y) * scene.width + x][1] = std::uint8_t(37 * k);
                  });
    }
    TextureKernels<F> kernels(scene, model::awkward_coordinates(scene.triangles.size(), config, n));
    const auto picture = kernels.shade(index, lit);
    all.insert(all.end(), picture.begin(), picture.end());
  }
  return all;
}

// Formats read at run time draw what compiled ones draw, with all stamps.
template <class C>
void expect_same_pictures() {
  const Config config = C::config();
  std::vector<model::NamedFrame> frames = frames_of(config);
  frames.resize(std::min<std::size_t>(frames.size(), 12));
  const auto want = pictures_of<Formats<C, Stamp4>>(config, frames);
  EXPECT_EQ((pictures_of<Formats<C, Stamp1>>(config, frames)), want);
  EXPECT_EQ((pictures_of<Formats<C, Stamp16>>(config, frames)), want);
  RuntimeFormats<Stamp4>::activate(config, format_table(config));
  EXPECT_EQ(pictures_of<RuntimeFormats<Stamp4>>(config, frames), want);
}
TEST(TextureFormats, ReadAtRunTimeDrawTheSame) {
  expect_same_pictures<TexturedLow>();
  expect_same_pictures<TexturedFlat>();
  expect_same_pictures<TexturedPhong>();
}

}  // namespace
}  // namespace halfspace::tests
