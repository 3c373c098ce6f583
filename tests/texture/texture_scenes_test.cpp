// SPDX-License-Identifier: Apache-2.0
// Scenes with texture in the kernels: where each pixel lies among texels, and its colour, against exact ones and their
// bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

#include "model/formats/configuration.hpp"
#include "ref/error.hpp"
#include "ref/geometry/surface.hpp"
#include "ref/raster/architecture.hpp"
#include "tests/config_path.hpp"
#include "tests/texture/texture_exact.hpp"
#include "tests/texture/texture_kernels.hpp"
#include "tests/texture/textured_configs.hpp"

namespace halfspace::tests {
namespace {

// Waves, or noise.
ref::Texture made_texture(const std::string& name, int width, int height, bool noise) {
  std::mt19937 random(7);
  ref::Texture texture{name, width, height, {}};
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      auto& texel = texture.texels.emplace_back();
      for (int c = 0; c < 3; ++c) {
        const double turn = 2 * M_PI * ((1 + c) * double(i) / width + (3 - c) * double(j) / height);
        texel[c] = noise ? std::uint8_t(random()) : std::uint8_t(127.5 + 127 * std::sin(turn));
      }
    }
  }
  return texture;
}

// A built-in scene in two textures, by the positions of its vertices: some triangles span several repetitions, some a
// part.
ref::Scene textured_scene(const std::string& name) {
  ref::Scene scene = ref::load_scene(name);
  scene.textures = {made_texture("waves", 64, 64, false), made_texture("noise", 128, 32, true),
                    made_texture("odd", 100, 60, false)};
  for (ref::Mesh& mesh : scene.meshes) {
    glm::dvec3 least(1e30), most(-1e30);
    for (const glm::dvec3& p : mesh.positions) least = glm::min(least, p), most = glm::max(most, p);
    const double size = glm::length(most - least);
    for (const glm::dvec3& p : mesh.positions) {
      const glm::dvec3 q = (p - least) / size;
      mesh.texture_coordinates.emplace_back(3.1 * q.x + 1.3 * q.z - 0.7, 2.3 * q.y - 0.9 * q.z);
    }
  }
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    scene.materials[m].texture = int(m % 4) - (m % 4 == 3 ? 4 : 0);
  return scene;
}

ref::ShadingMode mode_of(const Config& config) {
  return is_phong(config)     ? ref::ShadingMode::kPhong
         : is_gouraud(config) ? ref::ShadingMode::kGouraud
                              : ref::ShadingMode::kFlat;
}

struct Result {
  std::uint64_t pixels = 0, sure = 0, differ = 0;
  double share = 0, bound = 0, place = 0, colour = 0;
  int largest = 0;
};

// The largest difference of two texels side by side that a bilinear filter within `reach` of a place can see.
glm::dvec2 steepest(const ref::Texture& texture, const glm::dvec2& at, const glm::dvec2& reach, int c) {
  const auto first = [](double x, double r) { return std::int64_t(std::floor(x - r)); };
  const auto last = [](double x, double r) { return std::int64_t(std::floor(x + r)) + 1; };
  glm::dvec2 most(0);
  for (std::int64_t j = first(at.y, reach.y); j <= last(at.y, reach.y); ++j) {
    for (std::int64_t i = first(at.x, reach.x); i <= last(at.x, reach.x); ++i) {
      const int here = texture.at(i, j)[c];
      if (i < last(at.x, reach.x)) most.x = std::max(most.x, std::fabs(here - texture.at(i + 1, j)[c]));
      if (j < last(at.y, reach.y)) most.y = std::max(most.y, std::fabs(here - texture.at(i, j + 1)[c]));
    }
  }
  return most;
}

template <class C>
void compare(const std::string& name, ref::Scene scene, int width, int height, Result& total) {
  using F = Formats<C, Stamp4>;
  const Config config = C::config();
  model::fit_textures(scene, config);
  const ref::RasterFormat format = model::raster_format(configuration_of(config));
  ref::Geometry geometry(scene, {width, height, config.range_bits, config.subpixel_bits});
  const ref::SnappedList list = ref::snap(geometry.positions(), format);
  const model::TextureFrame frame = model::texture_frame(geometry, config);
  const auto lit_surface = ref::lit_surface(geometry, list, mode_of(config));
  const ref::Drawing lit = ref::draw(list, *lit_surface, ref::Architecture::kDelta);
  const ref::TextureMode mode{
      is_bilinear(config) ? ref::TextureFilter::kBilinear : ref::TextureFilter::kNearest,
      has_perspective(config) ? ref::TextureMapping::kPerspective : ref::TextureMapping::kAffine};
  const auto surface = ref::textured_surface(ref::lit_surface(geometry, list, mode_of(config)), geometry, list, mode);
  const ref::Drawing want = ref::draw(list, *surface, ref::Architecture::kDelta);
  TextureKernels<F> kernels(list, frame);
  const auto got = kernels.shade(lit.triangle, lit.colour);

  Result result;
  const int full = (1 << config.colour_bits) - 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t at = std::size_t(y) * width + x;
      const std::uint32_t k = lit.triangle[at];
      if (k == 0 || geometry.texture(k - 1) < 0) {
        EXPECT_EQ(got[at], lit.colour[at]);
        continue;
      }
      ++result.pixels;
      const ref::Texture& texture = scene.textures[std::size_t(geometry.texture(k - 1))];
      const glm::dvec2 sides(texture.width, texture.height);
      const auto [exact, bound] = exact_place(config, list.triangles[k - 1], geometry.uv(k - 1),
                                              geometry.origins()[k - 1].w, frame.triangles[k - 1], sides, x, y);
      const glm::dvec2 where = exact * sides - (is_bilinear(config) ? 0.5 : 0.0);
      const auto place = kernels.position(k, x, y);
      const glm::dvec2 places(raw(place.u), raw(place.v));
      // What the nearest cuts off does not matter: it is half of it to either side of the middle.
      const double cut = is_bilinear(config) ? 0 : std::ldexp(0.5, -kWeightBits);
      for (int i = 0; i < 2; ++i) {
        const double error =
            std::fabs(std::remainder(std::ldexp(places[i], -kWeightBits) + cut - where[i], sides[i])) - cut;
        EXPECT_LE(error, bound[i]) << name << ", pixel " << x << ", " << y;
        result.share = std::max(result.share, error / bound[i]);
        result.place = std::max(result.place, error), result.bound = std::max(result.bound, bound[i]);
      }
      std::uint64_t texels = 0;
      const glm::dvec3 texel = ref::sample(texture, exact, mode.filter, texels);
      const bool inside =
          std::fabs(where.x - std::round(where.x)) > bound.x && std::fabs(where.y - std::round(where.y)) > bound.y;
      for (int c = 0; c < 3; ++c) {
        const int value = ref::snapped_colour(got[at][c], config.colour_bits),
                  by = ref::snapped_colour(lit.colour[at][c], config.colour_bits);
        if (is_bilinear(config)) {
          const glm::dvec2 steep = steepest(texture, where, bound, c);
          const double most = (glm::dot(bound, steep) + std::ldexp(1.0, -kFilteredFraction - 1)) * by / full +
                              std::ldexp(1.0, -config.colour_bits - 1) + std::ldexp(1.0, -config.colour_bits - 8);
          const double error = std::fabs(value - by * texel[c] / full);
          EXPECT_LE(error, 0.5 + most) << name << ", pixel " << x << ", " << y << ", channel " << c;
          result.colour = std::max(result.colour, error - 0.5);
        } else if (inside) {
          const int raw_texel = ref::snapped_colour(texel[c], config.colour_bits);
          EXPECT_EQ(value, (2 * by * raw_texel + full) / (2 * full))
              << name << ", pixel " << x << ", " << y << ", channel " << c;
        }
        const int off = std::abs(int(got[at][c]) - int(want.colour[at][c]));
        result.differ += off != 0, result.largest = std::max(result.largest, off);
      }
      result.sure += inside;
      if (testing::Test::HasFailure()) return;
    }
  }
  std::printf(
      "%-15s %-12s %7llu pixels, %.4f inside a texel; place off by %.4f texels (largest bound %.3f; %.3f of a "
      "pixel's); colour "
      "%.3f LSB beyond rounding; %llu channels differ, by %d at most\n",
      config.name, name.c_str(), static_cast<unsigned long long>(result.pixels),
      double(result.sure) / double(result.pixels), result.place, result.bound, result.share, result.colour,
      static_cast<unsigned long long>(result.differ), result.largest);
  EXPECT_GT(result.pixels, 1000u) << name;
  total.pixels += result.pixels, total.sure += result.sure;
  total.share = std::max(total.share, result.share);
}

template <class C>
void compare_all(int width, int height) {
  Result total;
  for (const std::string& name : ref::builtin_scene_names()) {
    const ref::Scene scene = textured_scene(name);
    compare<C>(name, scene, width, height, total);
  }
  for (const char* file : {"/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", "/Collada/duck.dae"}) {
    const std::string path = std::string(HALFSPACE_TESTMODELS) + file;
    compare<C>(path.substr(path.find_last_of('/') + 1), ref::load_scene(path, 0, {true}), width, height, total);
  }
  EXPECT_GT(total.share, 0.3) << "the scenes are blind, or the bound is loose";
  if (!is_bilinear(C::config())) {
    EXPECT_GT(double(total.sure), 0.9 * double(total.pixels)) << "the bound leaves nothing to compare";
  }
}

TEST(TextureScenes, AreWithinTheBoundInLow) { compare_all<TexturedLow>(320, 200); }
TEST(TextureScenes, AreWithinTheBoundInMiddle) { compare_all<TexturedMiddle>(320, 240); }
TEST(TextureScenes, AreWithinTheBoundInHigh) { compare_all<TexturedHigh>(640, 480); }
TEST(TextureScenes, AreWithinTheBoundFlat) { compare_all<TexturedFlat>(160, 120); }
TEST(TextureScenes, AreWithinTheBoundWithPhong) { compare_all<TexturedPhong>(320, 200); }

}  // namespace
}  // namespace halfspace::tests
