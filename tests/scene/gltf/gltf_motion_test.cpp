// SPDX-License-Identifier: Apache-2.0
// Animations, skins and targets of a glTF file.
#include "tests/scene/gltf/gltf_file.hpp"

namespace halfspace::ref {
namespace {

using V3 = glm::dvec3;

// With an animation of node 0 by these accessors.
void animate(GltfFile* file, int times, int values, const std::string& path, const std::string& interpolation) {
  json animation{{"name", "wave"},
                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
                 {"samplers", {{{"input", times}, {"output", values}, {"interpolation", interpolation}}}}};
  file->root["animations"].push_back(animation);
}

TEST(GltfAnimations, AreReadByPathAndInterpolation) {
  GltfFile file;
  const int times = file.add<float>("SCALAR", 2, {0.5, 2});
  animate(&file, times, file.add<float>("VEC3", 2, {1, 2, 3, 4, 5, 6}), "translation", "STEP");
  animate(&file, times, file.add<std::int8_t>("VEC4", 2, {0, 0, 0, 127, 127, 0, 0, 0}, true), "rotation", "LINEAR");
  animate(&file, times, file.add<float>("VEC3", 6, std::vector<float>(18, 1)), "scale", "CUBICSPLINE");
  const Document document = file.read();
  ASSERT_EQ(document.animations.size(), 3u);
  EXPECT_EQ(document.animations[0].name, "wave");
  EXPECT_EQ(document.animations[0].duration, 2);
  const Channel &step = document.animations[0].channels[0], &linear = document.animations[1].channels[0],
                &cubic = document.animations[2].channels[0];
  EXPECT_EQ(step.path, ChannelPath::kTranslation);
  EXPECT_EQ(step.interpolation, Interpolation::kStep);
  EXPECT_EQ(step.values, std::vector<double>({1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(linear.values, std::vector<double>({0, 0, 0, 1, 1, 0, 0, 0}));
  EXPECT_EQ(cubic.interpolation, Interpolation::kCubic);
  EXPECT_EQ(cubic.values.size(), 18u);
}

TEST(GltfAnimations, WeightsAreOfTheTargetsOfTheMesh) {
  GltfFile file;
  const int moved = file.add<std::int8_t>("VEC3", 3, {0, 0, 1, 0, 0, 2, 0, 0, 3});
  file.primitive()["targets"] = {{{"POSITION", moved}}, {{"POSITION", moved}}};
  file.root["meshes"][0]["weights"] = {0.25, 0.5};
  file.root["nodes"][0]["weights"] = {0.75, 1};
  animate(&file, file.add<float>("SCALAR", 2, {0, 1}), file.add<float>("SCALAR", 4, {0, 1, 2, 3}), "weights", "LINEAR");
  const Document document = file.read();
  EXPECT_EQ(document.meshes[0].targets[1].positions[2], V3(0, 0, 3));
  EXPECT_EQ(document.meshes[0].targets[1].weight, 0.5);
  EXPECT_EQ(document.nodes[0].weights, std::vector<double>({0.75, 1}));
  EXPECT_EQ(document.animations[0].channels[0].values, std::vector<double>({0, 1, 2, 3}));
}

TEST(GltfSkins, JointsMayStandOutsideTheScene) {
  GltfFile file;
  file.attribute("JOINTS_0", file.add<std::uint8_t>("VEC4", 3, {1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}));
  file.attribute("WEIGHTS_0", file.add<std::uint8_t>("VEC4", 3, {255, 0, 0, 0, 51, 204, 0, 0, 255, 0, 0, 0}, true));
  std::vector<float> matrices(32, 0);
  for (const int i : {0, 5, 10, 15, 16, 21, 26, 31}) matrices[i] = 1;
  matrices[28] = 7;
  file.root["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", file.add("MAT4", 2, matrices)}}};
  file.root["nodes"] = json::parse(R"([{"mesh": 0, "skin": 0}, {"mesh": 0}, {}, {"children": [2], "name": "up"}])");
  const Document document = file.read();
  ASSERT_EQ(document.nodes.size(), 4u);
  EXPECT_EQ(document.nodes[0].skin, 0);
  EXPECT_EQ(document.nodes[2].name, "up");
  EXPECT_TRUE(document.nodes[1].meshes.empty());
  ASSERT_EQ(document.skins[0].size(), 2u);
  EXPECT_EQ(document.skins[0][0].node, 1);
  EXPECT_EQ(document.skins[0][1].node, 3);
  EXPECT_EQ(document.skins[0][1].from_mesh[3], glm::dvec4(7, 0, 0, 1));
  const std::vector<JointWeight>& weights = document.meshes[0].joint_weights;
  ASSERT_EQ(weights.size(), 4u);
  EXPECT_EQ(weights[2].vertex, 1u);
  EXPECT_EQ(weights[2].joint, 1u);
  EXPECT_EQ(weights[2].weight, 0.8);
}

}  // namespace
}  // namespace halfspace::ref
