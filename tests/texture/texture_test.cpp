// SPDX-License-Identifier: Apache-2.0
// Textures of the reference: where a texel is, how it is filtered, and perspective against rays through the pixels.
#include "ref/scene/texture.hpp"

#include <gtest/gtest.h>

#include <map>

#include "model/pipeline/engine.hpp"
#include "ref/error.hpp"
#include "ref/raster/architecture.hpp"

namespace {

using namespace halfspace;
using ref::TextureFilter;

ref::Texture checker(int size) {
  ref::Texture texture{"checker", size, size, {}};
  for (int n = 0; n < size * size; ++n) {
    texture.texels.push_back(
        {std::uint8_t(n % size * 8), std::uint8_t(n / size * 8), std::uint8_t(255 * ((n % size + n / size) % 2))});
  }
  return texture;
}

TEST(Texture, HasItsTexelsWhereItSays) {
  const ref::Texture texture = checker(4);
  std::uint64_t texels = 0;
  for (int j = -8; j < 8; ++j) {
    for (int i = -8; i < 8; ++i) {
      const glm::dvec2 uv((i + 0.5) / 4, (j + 0.5) / 4);
      const glm::dvec3 expected((i + 8) % 4 * 8, (j + 8) % 4 * 8, 255 * ((i + j + 16) % 2));
      EXPECT_EQ(sample(texture, uv, TextureFilter::kNearest, texels), expected);
      EXPECT_EQ(sample(texture, uv, TextureFilter::kBilinear, texels), expected);
    }
  }
  EXPECT_EQ(texels, 256u * 5);
  // Half-way between two texels, and between four.
  EXPECT_EQ(sample(texture, {0.25, 0.125}, TextureFilter::kBilinear, texels), glm::dvec3(4, 0, 127.5));
  EXPECT_EQ(sample(texture, {0.25, 0.25}, TextureFilter::kBilinear, texels), glm::dvec3(4, 4, 127.5));
}

TEST(Texture, IsScaledByMeans) {
  const ref::Texture half = resampled(checker(4), 2, 2);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.at(1, 0), (std::array<std::uint8_t, 3>{20, 4, 128}));
  EXPECT_EQ(resampled(checker(4), 4, 4).texels, checker(4).texels);
  const ref::Texture odd{
      "odd", 3, 2, {{0, 10, 100}, {30, 20, 100}, {60, 30, 100}, {0, 10, 200}, {30, 20, 200}, {60, 30, 200}}};
  EXPECT_EQ(resampled(odd, 2, 1).texels, (std::vector<std::array<std::uint8_t, 3>>{{10, 13, 150}, {50, 27, 150}}));
}

// A floor that runs away from the viewer: each pixel's ray meets it where the texture is looked up.
TEST(Texture, IsInPerspective) {
  ref::Scene scene;
  scene.name = "floor";
  ref::Mesh mesh;
  mesh.positions = {{-2, -1, -1}, {2, -1, -1}, {2, -1, -9}, {-2, -1, -9}};
  mesh.normals.assign(4, {0, 1, 0});
  for (const glm::dvec3& p : mesh.positions) mesh.texture_coordinates.emplace_back(p.x / 2, -p.z / 2);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes = {mesh};
  scene.materials.emplace_back();
  scene.materials[0].emission = glm::dvec3(1);  // white whatever the light
  scene.materials[0].texture = 0;
  scene.textures = {checker(32)};
  scene.instances = {{0, glm::dmat4(1)}};
  ref::Camera camera;
  camera.half_height = 1;
  camera.near = 0.1;
  camera.far = 100;
  scene.camera = camera;
  const int size = 128;
  ref::RasterFormat format = model::raster_format("high");
  ref::Geometry geometry(scene, {size, size, format.range_bits, format.subpixel_bits});
  const ref::SnappedList list = ref::snap(geometry.positions(), format);
  std::map<ref::TextureMapping, int> wrong;
  int seen = 0;
  for (const auto mapping : {ref::TextureMapping::kPerspective, ref::TextureMapping::kAffine}) {
    const auto surface = ref::textured_surface(ref::lit_surface(geometry, list, ref::ShadingMode::kFlat), geometry,
                                               list, {TextureFilter::kBilinear, mapping});
    const ref::Drawing drawing = ref::draw(list, *surface, ref::Architecture::kDelta);
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const std::size_t at = std::size_t(y) * size + x;
        if (drawing.triangle[at] == 0) continue;
        const double right = 2 * (x + 0.5) / size - 1, down = 2 * (y + 0.5) / size - 1, distance = 1 / down;
        const glm::dvec2 uv(right * distance / 2, distance / 2);
        std::uint64_t texels = 0;
        const glm::dvec3 expected = sample(scene.textures[0], uv, TextureFilter::kBilinear, texels);
        bool differs = false;
        for (int c = 0; c < 3; ++c)
          differs = differs || std::abs(expected[c] - drawing.colour[at][c]) > 12;  // positions are snapped
        wrong[mapping] += differs;
        seen += mapping == ref::TextureMapping::kPerspective;
      }
    }
  }
  EXPECT_GT(seen, 2000);
  EXPECT_LT(wrong[ref::TextureMapping::kPerspective], seen / 50);
  EXPECT_GT(wrong[ref::TextureMapping::kAffine], seen / 2);
}

// Fetched for each fragment that passes by alpha, for each pixel seen by the others, and the same picture.
TEST(Texture, IsFetchedAtScanOut) {
  const ref::RasterFormat format = model::raster_format("high");
  for (const char* file : {"/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", "/Collada/duck.dae"}) {
    SCOPED_TRACE(file);
    const ref::Scene scene = ref::load_scene(std::string(HALFSPACE_TESTMODELS) + file, 0, {true});
    ASSERT_FALSE(scene.textures.empty());
    for (const auto filter : {TextureFilter::kNearest, TextureFilter::kBilinear}) {
      const std::uint64_t each = filter == TextureFilter::kNearest ? 1 : 4;
      std::vector<std::array<std::uint8_t, 4>> picture;
      for (const ref::Architecture architecture : ref::kArchitectures) {
        ref::Geometry geometry(scene, {160, 120, format.range_bits, format.subpixel_bits});
        const ref::SnappedList list = ref::snap(geometry.positions(), format);
        const auto surface = ref::textured_surface(ref::lit_surface(geometry, list, ref::ShadingMode::kGouraud),
                                                   geometry, list, {filter});
        const ref::Drawing drawing = ref::draw(list, *surface, architecture);
        if (picture.empty()) picture = drawing.colour;
        EXPECT_EQ(drawing.colour, picture);
        const bool alpha = architecture == ref::Architecture::kAlpha;
        EXPECT_EQ(drawing.rates.texture_fetches,
                  each * (alpha ? drawing.rates.reduced_fragments : drawing.rates.visible_pixels));
      }
    }
  }
}

TEST(Texture, ThatIsMissingIsAnErrorWhenAskedFor) {
  const std::string file = std::string(HALFSPACE_TESTMODELS) + "/OBJ/spider.obj";
  EXPECT_NO_THROW(ref::load_scene(file));
  try {
    ref::read_texture("/nowhere/wall.png", true);
    ADD_FAILURE();
  } catch (const ref::Error& error) {
    EXPECT_NE(std::string(error.what()).find("wall.png"), std::string::npos);
  }
}

}  // namespace
