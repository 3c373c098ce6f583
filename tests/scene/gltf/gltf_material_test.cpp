// SPDX-License-Identifier: Apache-2.0
// What materials of a glTF file say, and their textures.
#include "ref/geometry/distant_lighting.hpp"
#include "ref/geometry/lighting.hpp"
#include "tests/scene/gltf/gltf_file.hpp"

namespace halfspace::ref {
namespace {

using V2 = glm::dvec2;
using V3 = glm::dvec3;

// A file with coordinates (0, 0), (1, 0), (0, 1), a picture, and it as the base colour.
GltfFile textured_file() {
  GltfFile file;
  file.attribute("TEXCOORD_0", file.add<float>("VEC2", 3, {0, 0, 1, 0, 0, 1}));
  file.add_picture();
  file.material()["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  return file;
}

TEST(GltfMaterials, TheDefaultIsWhiteAndDull) {
  const Material material = GltfFile().read().materials[0];
  EXPECT_EQ(material.diffuse, V3(1));
  EXPECT_EQ(material.ambient, V3(1));
  EXPECT_EQ(material.specular, V3(0));
  EXPECT_EQ(material.emission, V3(0));
  EXPECT_FALSE(material.two_sided || material.unlit);
}

TEST(GltfMaterials, FactorsAndFlagsAreRead) {
  GltfFile file;
  file.material() = json::parse(R"({"doubleSided": true, "emissiveFactor": [0.1, 0.2, 0.3],
    "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 2, 0.1], "roughnessFactor": 0.5},
    "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 10}}})");
  const Material material = file.read().materials[0];
  EXPECT_EQ(material.diffuse, V3(0.5, 0.25, 1));
  EXPECT_EQ(material.emission, V3(1, 2, 3));
  EXPECT_TRUE(material.two_sided);
  file.material()["extensions"] = {{"KHR_materials_unlit", json::object()}};
  EXPECT_TRUE(file.read().materials[0].unlit);
}

TEST(GltfMaterials, UnlitOnesHaveTheirColourWhateverTheLight) {
  Material material;
  material.unlit = true;
  material.diffuse = {0.5, 1, 0.25};
  material.emission = material.specular = V3(1);
  const SurfacePoint point{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {1, 0.5, 1}};
  EXPECT_EQ(phong(point, material, V3(1), {Light(), Light()}), V3(127.5, 127.5, 63.75));
  EXPECT_EQ(phong(point, material, V3(0), {}), V3(127.5, 127.5, 63.75));
  Scene scene;
  scene.materials = {material};
  scene.meshes = {
      {"face", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {}, {}, {{0, 1, 2}}, 0}};
  scene.instances = {{0, glm::dmat4(1)}};
  scene.framing = scene.meshes[0].positions;
  const DistantScene distant = distant_scene(scene, viewpoint(scene, 1), 4);
  EXPECT_EQ(distant_colour(distant.materials[0], distant.lights, {0, 0, 1}), V3(127.5, 255, 63.75));
}

TEST(GltfMaterials, EmissionIsFactorTimesMap) {
  GltfFile file;
  file.add_picture();
  file.material() = {{"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}};
  for (const bool textured : {false, true}) {
    const Document document = file.read(textured);
    EXPECT_EQ(document.materials[0].emission, V3(0.5, 0.5, 0));
    EXPECT_EQ(document.remarks.size(), 1u);
  }
  // Where nothing is lit, the map is the texture.
  file.attribute("TEXCOORD_0", file.add<float>("VEC2", 3, {0, 0, 1, 0, 0, 1}));
  file.material()["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
  const Document document = file.read(true);
  EXPECT_EQ(document.materials[0].emission, V3(1));
  EXPECT_EQ(document.materials[0].texture, 0);
  EXPECT_TRUE(document.remarks.empty());
}

TEST(GltfMaterials, OtherMapsAreSaidToBeLeftOut) {
  GltfFile file;
  file.add_picture();
  file.material()["normalTexture"]["index"] = 0;
  EXPECT_EQ(file.read().remarks,
            std::vector<std::string>{"maps of normals, occlusion, metal and roughness are left out"});
}

TEST(GltfMaterials, AlphaIsDrawnOpaqueWithAWord) {
  const auto remarks = [](const char* mode, double alpha, bool textured) {
    GltfFile file = textured ? textured_file() : GltfFile();
    file.material()["alphaMode"] = mode;
    file.material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, alpha};
    const Document document = file.read();
    return document.meshes.empty()    ? std::string("left out")
           : document.remarks.empty() ? std::string()
                                      : document.remarks[0];
  };
  EXPECT_EQ(remarks("OPAQUE", 0.1, true), "");
  EXPECT_EQ(remarks("MASK", 0.4, false), "left out");
  EXPECT_EQ(remarks("MASK", 0.6, false), "");
  EXPECT_EQ(remarks("MASK", 0.6, true), "what alpha cuts out (MASK) is drawn opaque");
  EXPECT_EQ(remarks("BLEND", 0, false), "left out");
  EXPECT_EQ(remarks("BLEND", 0.1, false), "what alpha lets shine through (BLEND) is drawn opaque");
}

TEST(GltfTextures, RowsAndCoordinatesGoUp) {
  const Document document = textured_file().read(true);
  ASSERT_EQ(document.textures.size(), 1u);
  EXPECT_EQ(document.textures[0].at(0, 0), (std::array<std::uint8_t, 3>{255, 0, 0}));
  EXPECT_EQ(document.textures[0].at(1, 0), (std::array<std::uint8_t, 3>{0, 255, 0}));
  EXPECT_EQ(document.meshes[0].mesh.texture_coordinates, (std::vector<V2>{{0, 1}, {1, 1}, {0, 0}}));
  EXPECT_TRUE(textured_file().read(false).textures.empty());
}

TEST(GltfTextures, AreTransformedAndOfTheSetThatIsNamed) {
  GltfFile file = textured_file();
  file.attribute("TEXCOORD_1", file.add<std::uint16_t>("VEC2", 3, {65535, 0, 0, 0, 0, 65535}, true));
  json& info = file.material()["pbrMetallicRoughness"]["baseColorTexture"];
  info["texCoord"] = 1;
  EXPECT_EQ(file.read(true).meshes[0].mesh.texture_coordinates[0], V2(1, 1));
  // That of the specification: the lower left quarter, turned.
  info["extensions"]["KHR_texture_transform"] =
      json::parse(R"({"offset": [0, 1], "rotation": 1.57079632679, "scale": [0.5, 0.5], "texCoord": 0})");
  const std::vector<V2> placed = file.read(true).meshes[0].mesh.texture_coordinates;
  EXPECT_NEAR(glm::distance(placed[0], V2(0, 0)), 0, 1e-9);
  EXPECT_NEAR(glm::distance(placed[1], V2(0, 0.5)), 0, 1e-9);
  EXPECT_NEAR(glm::distance(placed[2], V2(0.5, 0)), 0, 1e-9);
}

TEST(GltfTextures, ThoseThatDoNotRepeatAreSaidToIfItIsSeen) {
  GltfFile file = textured_file();
  file.root["textures"][0]["sampler"] = 0;
  file.root["samplers"] = {{{"wrapS", 33071}}};
  EXPECT_TRUE(file.read(true).remarks.empty());
  file.attribute("TEXCOORD_0", file.add<float>("VEC2", 3, {0, 0, 1.5, 0, 0, 1}));
  EXPECT_EQ(file.read(true).remarks.size(), 1u);
  file.root["samplers"][0]["wrapS"] = 10497;
  EXPECT_TRUE(file.read(true).remarks.empty());
}

TEST(GltfTextures, AreFilesBesideTheSceneByTheirUri) {
  GltfFile file = textured_file();
  const TemporaryFile picture("a b+%41ü.png", "no picture");
  file.root["images"][0]["uri"] = "nowhere/halfspace_ref_a%20b+%2541%C3%BC.png";
  expect_in("is neither PNG nor JPEG", refusal([&] { file.read(true); }));
  file.root["images"][0]["uri"] = "other.png";
  expect_in("its texture 'other.png' is not there", refusal([&] { file.read(true); }));
  EXPECT_EQ(file.read(false).meshes.size(), 1u);
}

}  // namespace
}  // namespace halfspace::ref
