// SPDX-License-Identifier: Apache-2.0
// Perspective-correct texture against Mesa's llvmpipe, on the same triangles: snapped positions with their w, a texture
// that repeats and multiplies the colour of a triangle.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "model/pipeline/engine_impl.hpp"
#include "tests/raster/mesa.hpp"
#include "tests/texture/texture_exact.hpp"
#include "tests/texture/textured_configs.hpp"

namespace halfspace::tests {
namespace {

constexpr int kSize = 128, kSide = 64, kTriangles = 2000;

struct PerspectiveNearest {
  static constexpr Config config() {
    Config config = TexturedMiddle::config();
    config.texture = TextureFilter::kNearest;
    return config;
  }
};

// Each texel has its own colour; waves that wrap smoothly, or a colour for each column and row.
ref::Texture picture(bool smooth) {
  ref::Texture texture{"picture", kSide, kSide, {}};
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const auto wave = [](double turns) {
        return std::uint8_t(std::lround(127.5 + 127.5 * std::sin(2 * M_PI * turns / kSide)));
      };
      if (smooth) texture.texels.push_back({wave(i), wave(2 * j), wave(i + j)});
      else
        texture.texels.push_back(
            {std::uint8_t(4 * i), std::uint8_t(4 * j), std::uint8_t(4 * ((i + 16 * (j % 4)) % kSide))});
    }
  }
  return texture;
}

// A triangle within the frame, of 32 pixels or more: the planes of llvmpipe are of floats, and its slivers are its own
// matter.
struct Case {
  ref::SnappedTriangle triangle{};
  std::array<glm::dvec2, 3> uv;
  std::array<double, 3> w;
};
Case made_case(std::mt19937_64& random) {
  const auto in = [&](int low, int high) { return low + int(random() % std::uint64_t(high - low + 1)); };
  Case out;
  std::int64_t area = 0;
  while (std::llabs(area) < 2 * 32 * 256 * 256) {
    for (int v = 0; v < 3; ++v) out.triangle.x[v] = in(0, kSize * 256), out.triangle.y[v] = in(0, kSize * 256);
    const auto& t = out.triangle;
    area = std::int64_t(t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - std::int64_t(t.x[2] - t.x[0]) * (t.y[1] - t.y[0]);
  }
  for (int v = 0; v < 3; ++v) {
    out.uv[v] = {in(-1024, 2048) / 1024.0, in(-1024, 2048) / 1024.0};
    out.w[v] = std::ldexp(double(in(128, 255)), in(-7, -4));  // x·w has 23 bits: exact in float
    out.triangle.depth[v] = 1 << 23;
  }
  return out;
}

// Channels that differ by 0, 1, 2, 3 and more.
struct Differences {
  std::array<std::uint64_t, 5> channels{};
  int largest = 0;
  void add(int a, int b) {
    const int by = std::abs(a - b);
    ++channels[std::size_t(std::min(by, 4))];
    largest = std::max(largest, by);
  }
  void print(const char* what) const {
    std::printf("  %-22s", what);
    for (std::size_t by = 0; by < 5; ++by)
      std::printf("  %zu%s: %llu", by, by == 4 ? "…" : "", static_cast<unsigned long long>(channels[by]));
    std::printf("\n");
  }
};

struct Comparison {
  std::uint64_t pixels = 0, coverage = 0;
  Differences kernels, reference, both;
  // Pixels that show another texel than the exact one, and how far that is from its border at most.
  std::uint64_t kernels_other = 0, mesa_other = 0;
  double kernels_farthest = 0, mesa_farthest = 0;
};

template <class C>
Comparison compare(bool coloured) {
  using F = Formats<C, Stamp4>;
  const Config config = C::config();
  const bool smooth = is_bilinear(config);
  const auto filter = smooth ? ref::TextureFilter::kBilinear : ref::TextureFilter::kNearest;
  const ref::Texture texture = picture(smooth);
  Mesa mesa(kSize, kSize);
  mesa.texture(texture, filter);
  model::KernelEngine<F> engine;
  std::mt19937_64 random(42);
  ref::SnappedList scene;
  scene.format = model::raster_format(model::Configuration(config.name, config));
  scene.width = scene.height = kSize;
  scene.background = {0, 0, 0};
  scene.triangles.resize(1);
  model::TextureFrame frame = model::loaded_textures({texture}, config);
  frame.triangles.resize(1);
  Comparison result;
  for (int n = 0; n < kTriangles; ++n) {
    Case c = made_case(random);
    std::array<std::uint8_t, 3> colour{255, 255, 255};
    if (coloured) colour = {std::uint8_t(random()), std::uint8_t(random()), std::uint8_t(random())};
    Mesa::Textured arrays;
    for (int v = 0; v < 3; ++v) {
      c.triangle.rgb[v] = colour;
      const double x = c.triangle.x[v] / 256.0, y = c.triangle.y[v] / 256.0;
      for (const double value : {x * c.w[v], y * c.w[v], 0.5 * c.w[v], c.w[v]})
        arrays.positions.push_back(float(value));
      for (const double value : {c.uv[v].x, c.uv[v].y}) arrays.coordinates.push_back(float(value));
      arrays.colours.insert(arrays.colours.end(), {colour[0], colour[1], colour[2], 255});
    }
    mesa.clear(0, 0, 0, 0);
    const std::vector<std::uint32_t>& by_mesa = mesa.draw(arrays);

    scene.triangles[0] = c.triangle;
    frame.triangles[0] = model::quantized_coordinates(c.uv, c.w, config, "a triangle");
    frame.triangles[0].texture = 1;
    engine.texture(frame);
    const ref::Frame drawn = engine.render(scene);
    const auto& by_kernels = drawn.colour;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const std::size_t at = std::size_t(y) * kSize + x;
        const bool covered = drawn.index[at] != 0;
        result.coverage += covered != (by_mesa[at] >> 24 != 0);
        if (!covered) continue;
        ++result.pixels;
        const auto [uv, bound] =
            exact_place(config, c.triangle, c.uv, c.w, frame.triangles[0], glm::dvec2(kSide), x, y);
        std::uint64_t texels = 0;
        const glm::dvec3 texel = ref::sample(texture, uv, filter, texels);
        bool kernels_differ = false, mesa_differs = false;
        for (int i = 0; i < 3; ++i) {
          const int expected = ref::snapped_colour(colour[i] * texel[i] / 255, 8),
                    theirs = int(by_mesa[at] >> 8 * i & 255);
          result.kernels.add(by_kernels[at][i], theirs);
          result.reference.add(expected, theirs);
          result.both.add(by_kernels[at][i], expected);
          kernels_differ = kernels_differ || by_kernels[at][i] != expected;
          mesa_differs = mesa_differs || theirs != expected;
        }
        const glm::dvec2 place = uv * double(kSide), to = glm::abs(place - glm::round(place));
        const bool near_border = to.x <= bound.x || to.y <= bound.y;
        if (!smooth && kernels_differ) {
          EXPECT_TRUE(near_border) << "triangle " << n << ", pixel " << x << ", " << y;
          ++result.kernels_other;
          result.kernels_farthest = std::max(result.kernels_farthest, std::min(to.x, to.y));
        }
        if (!smooth && mesa_differs) {
          ++result.mesa_other;
          result.mesa_farthest = std::max(result.mesa_farthest, std::min(to.x, to.y));
        }
      }
    }
  }
  std::printf("%s, %s: %d triangles, %llu pixels, %llu of them covered otherwise\n",
              smooth ? "GL_LINEAR" : "GL_NEAREST", coloured ? "coloured" : "white", kTriangles,
              static_cast<unsigned long long>(result.pixels), static_cast<unsigned long long>(result.coverage));
  result.kernels.print("kernels and Mesa");
  result.reference.print("reference and Mesa");
  result.both.print("kernels and reference");
  if (!smooth) {
    std::printf(
        "  another texel than the exact one: kernels %llu pixels, %.5f texels from its border at most; Mesa %llu, "
        "%.5f\n",
        static_cast<unsigned long long>(result.kernels_other), result.kernels_farthest,
        static_cast<unsigned long long>(result.mesa_other), result.mesa_farthest);
  }
  return result;
}

// llvmpipe weights texels with 8 bits too, but rounds after each of three interpolations, and once more after the
// product: up to half an LSB each, of which the interpolations of the columns are weighted with 1 together. The kernels
// are within 0.7 LSB of the exact colour on waves as smooth as these.
TEST(TextureMesa, LinearFilter) {
  for (const bool coloured : {false, true}) {
    const Comparison result = compare<TexturedMiddle>(coloured);
    EXPECT_EQ(result.coverage, 0u);
    EXPECT_GT(result.pixels, 1000000u);
    EXPECT_LE(result.kernels.largest, 2);
    EXPECT_LE(result.reference.largest, 2);
    EXPECT_LE(result.both.largest, 1);
  }
}

// On the right side of a border they show the same. llvmpipe's planes are of floats, 24 bits: over a frame of 128
// pixels, and in a texture that is repeated up to three times, they are within 2^-12 texels here, as seen.
TEST(TextureMesa, NearestFilter) {
  const Comparison result = compare<PerspectiveNearest>(false);
  EXPECT_EQ(result.coverage, 0u);
  EXPECT_GT(result.pixels, 1000000u);
  EXPECT_LT(result.kernels_farthest, 0.001);
  EXPECT_LT(result.mesa_farthest, 0.001);
  EXPECT_LT(result.kernels_other + result.mesa_other, result.pixels / 1000);
}

}  // namespace
}  // namespace halfspace::tests
