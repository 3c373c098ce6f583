// SPDX-License-Identifier: Apache-2.0
// What accessors, primitives and nodes of a glTF file say.
#include "tests/scene/gltf/gltf_file.hpp"

namespace halfspace::ref {
namespace {

using V3 = glm::dvec3;
using Corner = std::array<std::uint32_t, 3>;

// The positions that a file of these numbers has.
template <class Number>
std::vector<V3> positions(const std::vector<Number>& numbers, bool normalized) {
  GltfFile file;
  file.attribute("POSITION", file.add("VEC3", 3, numbers, normalized));
  return file.read().meshes[0].mesh.positions;
}

TEST(GltfAccessors, NumbersOfEveryTypeAreRead) {
  const std::vector<V3> plain{{0, 1, 2}, {100, 3, 4}, {5, 6, 127}};
  const std::vector<int> numbers{0, 1, 2, 100, 3, 4, 5, 6, 127};
  EXPECT_EQ(positions(std::vector<std::int8_t>(numbers.begin(), numbers.end()), false), plain);
  EXPECT_EQ(positions(std::vector<std::uint8_t>(numbers.begin(), numbers.end()), false), plain);
  EXPECT_EQ(positions(std::vector<std::int16_t>(numbers.begin(), numbers.end()), false), plain);
  EXPECT_EQ(positions(std::vector<std::uint16_t>(numbers.begin(), numbers.end()), false), plain);
  EXPECT_EQ(positions(std::vector<std::uint32_t>(numbers.begin(), numbers.end()), false), plain);
  EXPECT_EQ(positions(std::vector<float>(numbers.begin(), numbers.end()), false), plain);
}

TEST(GltfAccessors, NormalizedOnesReachOneAtBothEnds) {
  EXPECT_EQ(positions<std::int8_t>({127, -127, -128, 0, 0, 0, 0, 0, 0}, true)[0], V3(1, -1, -1));
  EXPECT_EQ(positions<std::uint8_t>({255, 0, 51, 0, 0, 0, 0, 0, 0}, true)[0], V3(1, 0, 51 / 255.0));
  EXPECT_EQ(positions<std::int16_t>({32767, -32767, -32768, 0, 0, 0, 0, 0, 0}, true)[0], V3(1, -1, -1));
  EXPECT_EQ(positions<std::uint16_t>({65535, 0, 13107, 0, 0, 0, 0, 0, 0}, true)[0], V3(1, 0, 0.2));
}

TEST(GltfAccessors, StrideAndOffsetsAreKept) {
  GltfFile file;
  const int accessor = file.add<float>("VEC3", 3, {9, 9, 1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 9});
  file.root["bufferViews"][1]["byteStride"] = 16;
  file.root["accessors"][accessor]["byteOffset"] = 8;
  file.attribute("POSITION", accessor);
  EXPECT_EQ(file.read().meshes[0].mesh.positions, (std::vector<V3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
}

TEST(GltfAccessors, SparseOnesReplaceElements) {
  for (const bool has_view : {true, false}) {
    GltfFile file;
    const int at = file.add_view<std::uint16_t>({0, 2}), values = file.add_view<float>({7, 8, 9, 4, 5, 6});
    json& accessor = file.root["accessors"][0];
    if (!has_view) accessor.erase("bufferView");
    accessor["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", at}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
    EXPECT_EQ(file.read().meshes[0].mesh.positions, (std::vector<V3>{{7, 8, 9}, {has_view ? 1 : 0, 0, 0}, {4, 5, 6}}));
  }
}

TEST(GltfAccessors, IndicesMayHaveNoView) {
  GltfFile file;
  file.root["accessors"].push_back({{"componentType", 5121}, {"count", 3}, {"type", "SCALAR"}});
  file.primitive()["indices"] = 1;
  file.add_normals(3);
  EXPECT_EQ(file.read().meshes[0].mesh.triangles, (std::vector<Corner>{{0, 0, 0}}));
}

TEST(GltfAccessors, BuffersMayBeLongerThanTheySay) {
  GltfFile file;
  const TemporaryFile buffer("long.bin", file.bytes + std::string(5000, 'x'));
  file.root["buffers"] = {{{"byteLength", file.bytes.size()}, {"uri", "halfspace_ref_long.bin"}}};
  EXPECT_EQ(file.read().meshes[0].mesh.positions[1], V3(1, 0, 0));
}

TEST(GltfPrimitives, ModesBecomeTriangles) {
  const std::vector<std::pair<int, std::vector<Corner>>> cases{{4, {{0, 1, 2}, {3, 4, 5}}},
                                                               {5, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}}},
                                                               {6, {{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}}}};
  for (const auto& [mode, triangles] : cases) {
    GltfFile file;
    file.attribute("POSITION", file.add("VEC3", 6, std::vector<float>(18, 0)));
    file.add_normals(6);
    file.primitive()["mode"] = mode;
    EXPECT_EQ(file.read().meshes[0].mesh.triangles, triangles) << mode;
  }
  GltfFile points;
  points.root["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 0}});
  points.root["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"mode", 1}});
  EXPECT_EQ(points.read().remarks,
            (std::vector<std::string>{"1 primitives of points are left out", "1 primitives of lines are left out"}));
}

TEST(GltfPrimitives, HaveTheVerticesThatTheyUse) {
  GltfFile file;
  file.attribute("POSITION", file.add<float>("VEC3", 5, {9, 9, 9, 0, 0, 0, 9, 9, 9, 1, 0, 0, 0, 1, 0}));
  file.primitive()["indices"] = file.add<std::uint8_t>("SCALAR", 3, {4, 1, 3});
  file.add_normals(5);
  const Mesh mesh = file.read().meshes[0].mesh;
  EXPECT_EQ(mesh.positions, (std::vector<V3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Corner>{{2, 0, 1}}));
}

TEST(GltfPrimitives, NormalsAreUnitOrFlat) {
  GltfFile file;
  EXPECT_TRUE(file.read().meshes[0].is_flat);
  file.attribute("NORMAL", file.add<float>("VEC3", 3, {0, 0, 2, 0, 0, 0, 3, 0, 4}));
  const DocumentMesh mesh = file.read().meshes[0];
  EXPECT_FALSE(mesh.is_flat);
  EXPECT_EQ(mesh.mesh.normals[0], V3(0, 0, 1));
  EXPECT_EQ(mesh.mesh.normals[1], V3(0, 0, 1));  // that of the face
  EXPECT_NEAR(glm::distance(mesh.mesh.normals[2], V3(0.6, 0, 0.8)), 0, 1e-12);
}

TEST(GltfPrimitives, ColoursAreClampedAndAlphaIsLeft) {
  GltfFile file;
  file.attribute("COLOR_0", file.add<float>("VEC4", 3, {2, -1, 0.5, 0, 0, 0, 0, 1, 1, 1, 1, 1}));
  EXPECT_EQ(file.read().meshes[0].mesh.colours, (std::vector<V3>{{1, 0, 0.5}, {0, 0, 0}, {1, 1, 1}}));
}

TEST(GltfNodes, StandDepthFirstFromTheRootsOfTheScene) {
  GltfFile file;
  file.root["nodes"] = json::parse(R"([{"name": "a", "children": [2, 1], "translation": [1, 2, 3]}, {"name": "b"},
    {"name": "c", "children": [3]}, {"name": "d", "matrix": [0,2,0,0, -1,0,0,0, 0,0,3,0, 4,5,6,1]},
    {"name": "out"}, {"name": "Grün"}])");
  file.root["scenes"] = json::parse(R"([{"nodes": [0, 5]}, {"nodes": [4]}])");
  const Document document = file.read();
  std::string names;
  for (const Node& node : document.nodes) names += node.name + std::to_string(node.parent) + " ";
  EXPECT_EQ(names, "a-1 c0 d1 b0 Grün-1 ");
  EXPECT_EQ(document.nodes[0].matrix[3], glm::dvec4(1, 2, 3, 1));
  EXPECT_EQ(document.nodes[2].matrix[0], glm::dvec4(0, 2, 0, 0));
  EXPECT_EQ(document.nodes[2].scale, V3(2, 1, 3));
  EXPECT_EQ(document.remarks, std::vector<std::string>{"of 2 scenes the default one is drawn"});
  EXPECT_TRUE(document.meshes.empty());
}

TEST(GltfNodes, InstancesAreChildren) {
  GltfFile file;
  const int moved = file.add<float>("VEC3", 2, {1, 0, 0, 0, 5, 0});
  file.root["extensionsRequired"] = file.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  file.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = moved;
  const Document document = file.read();
  ASSERT_EQ(document.nodes.size(), 3u);
  EXPECT_TRUE(document.nodes[0].meshes.empty());
  EXPECT_EQ(document.nodes[2].matrix[3], glm::dvec4(0, 5, 0, 1));
  EXPECT_EQ(document.nodes[2].meshes, std::vector<int>{0});
}

TEST(GltfViews, CamerasAndLightsAreThoseOfNodes) {
  GltfFile file;
  file.root["cameras"] = json::parse(R"([
    {"type": "orthographic", "orthographic": {"xmag": 2, "ymag": -3, "znear": 0, "zfar": 9}},
    {"type": "perspective", "name": "same", "perspective": {"yfov": 1, "aspectRatio": 2, "znear": 0.1}}])");
  file.root["nodes"] = json::parse(R"([{"camera": 1, "children": [1]}, {"camera": 0, "name": "same",
    "extensions": {"KHR_lights_punctual": {"light": 0}}}])");
  file.root["extensions"] = json::parse(R"({"KHR_lights_punctual": {"lights": [
    {"type": "spot", "color": [1, 0.5, 0], "intensity": 4, "spot": {"outerConeAngle": 0.5}}]}})");
  const Document document = file.read();
  ASSERT_EQ(document.cameras.size(), 2u);
  const DocumentCamera &a = document.cameras[0], &b = document.cameras[1];
  EXPECT_TRUE(a.camera.orthographic);
  EXPECT_EQ(std::vector<double>({a.camera.half_width, a.camera.half_height, a.camera.near, a.camera.far}),
            std::vector<double>({2, 3, 0, 9}));
  EXPECT_EQ(a.node, 1);
  EXPECT_EQ(a.name + b.name, "samesame");
  EXPECT_DOUBLE_EQ(b.camera.half_height, std::tan(0.5));
  EXPECT_EQ(b.camera.far, 0);
  ASSERT_EQ(document.lights.size(), 1u);
  EXPECT_EQ(document.lights[0].light.colour, V3(4, 2, 0));
  EXPECT_DOUBLE_EQ(document.lights[0].light.cos_outer, std::cos(0.5));
  EXPECT_EQ(document.lights[0].light.attenuation, V3(0, 0, 1));
}

}  // namespace
}  // namespace halfspace::ref
