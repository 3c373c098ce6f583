// SPDX-License-Identifier: Apache-2.0
// Scene files: real ones are drawn, animations move what they should, wrong ones are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/geometry/three_formats.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {
namespace {

const std::string kModels = HALFSPACE_TESTMODELS "/";

Frame render_file(const std::string& path, double time = 0) {
  return render(snap(project(load_scene(path, time), {640, 480, kHigh.range_bits, kHigh.subpixel_bits}), kHigh));
}

TEST(Files, RealOnesAreDrawn) {
  for (const char* name : {"OBJ/spider.obj", "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
                           "Collada/duck.dae", "Collada/cube_UTF8BOM.dae", "OBJ/cube_with_vertexcolors.obj",
                           "PLY/cube.ply", "STL/Spider_binary.stl", "3DS/CameraRollAnim.3ds", "FBX/spider.fbx"}) {
    const std::string path = kModels + name;
    ASSERT_TRUE(std::filesystem::exists(path)) << path;
    try {
      const double share = double(covered(render_file(path))) / (640 * 480);
      EXPECT_GT(share, 0.02) << name;
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  }
}

TEST(Files, AnimationsMoveNodesAndBones) {
  for (const char* name : {"Collada/box_nested_animation.dae", "glTF2/simple_skin/simple_skin.gltf"}) {
    const Frame a = render_file(kModels + name), b = render_file(kModels + name, 1.2),
                again = render_file(kModels + name);
    EXPECT_EQ(a.index, again.index) << name;
    EXPECT_NE(a.depth, b.depth) << name;
  }
}

// One end of its cube has been moved by a target; its keys are 1/30 s apart, and lines lie between them.
TEST(Files, AnimationsMorphMeshes) {
  const std::string path = kModels + "glTF2/glTF-Sample-Models/AnimatedMorphCube-glTF/AnimatedMorphCube.gltf";
  const Scene still = load_scene(path);
  EXPECT_NEAR(still.duration, 4.2, 1e-3);
  const auto lowest = [](const Scene& scene) {
    double y = 1e9;
    const Mesh& mesh = scene.meshes[scene.instances[0].mesh];
    for (const auto& corner : mesh.triangles) {
      for (const std::uint32_t i : corner) y = std::min(y, mesh.positions[i].y);
    }
    return y;
  };
  EXPECT_NEAR(lowest(still), -0.01, 1e-6);
  // Weights of the first target, from the file.
  const double at_13 = lowest(load_scene(path, 13 / 30.0)), at_39 = lowest(load_scene(path, 39 / 30.0));
  EXPECT_NEAR(at_13, -0.01 + 0.18032 * 0.01893253, 1e-5);
  EXPECT_NEAR(at_39, -0.01 + 0.907715 * 0.01893253, 1e-5);
  const double at_14 = lowest(load_scene(path, 14 / 30.0));
  EXPECT_NEAR(lowest(load_scene(path, 13.5 / 30.0)), (at_13 + at_14) / 2, 1e-6);
  EXPECT_LT(covered(render_file(path, 3)), covered(render_file(path)));
}

// A triangle, and a camera that goes from (0, 0, 5) to (0, 0, 10) in a second.
TEST(Files, AnimationsMoveCameras) {
  const TemporaryFile file(
      "camera.gltf",
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0,"name":"face"},{")"
      R"(camera":0,"name":"eye","translation":[0,0,5]}],"cameras":[{"type":"perspective","perspective":{"yfov)"
      R"(":0.8,"aspectRatio":1,"znear":0.1,"zfar":100}}],"meshes":[{"primitives":[{"attributes":{"POSITION":0)"
      R"(}}]}],"buffers":[{"byteLength":68,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPw)"
      R"(AAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAoEAAAAAAAAAAAAAAIEE="}],"bufferViews":[{"buffer":0)"
      R"(,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":8},{"buffer":0,"byteOffset":44,"byteLengt)"
      R"(h":24}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max)"
      R"(":[1,1,0]},{"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR","min":[0],"max":[1]},{"buf)"
      R"(ferView":2,"componentType":5126,"count":2,"type":"VEC3"}],"animations":[{"channels":[{"sampler":0,"t)"
      R"(arget":{"node":1,"path":"translation"}}],"samplers":[{"input":1,"output":2}]}]})");
  for (const double seconds : {0.0, 0.25, 1.0, 2.0}) {
    const Scene scene = load_scene(file.path(), seconds);
    ASSERT_TRUE(scene.camera);
    EXPECT_NEAR(scene.camera->position.z, 5 + 5 * std::min(seconds, 1.0), 1e-6);
  }
  EXPECT_GT(covered(render_file(file.path())), 3 * covered(render_file(file.path(), 1)));
}

TEST(Files, InvalidOnesAreRefused) {
  for (const char* name :
       {"invalid/empty.obj", "invalid/empty.off", "invalid/empty.ply", "invalid/empty.3ds", "invalid/empty.x",
        "invalid/OutOfMemory.off", "invalid/malformed.obj", "glTF2/MissingBin/BoxTextured.gltf",
        "glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "glTF2/RecursiveNodes/RecursiveNodes.gltf"}) {
    expect_in(kModels + name + ": ", refusal([&] { render_file(kModels + name); }));
  }
}

TEST(Files, WrongOnesAreRefusedWithTheirPlace) {
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "empty"},
      {"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a coordinate is NaN or infinite"},
      {"v 0 inf 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a coordinate is NaN or infinite"},
      {triangle + "f 1 2 9\n", "cannot be read as a mesh"},
      {triangle, "there are no triangles in it"},
      {triangle + "l 1 2\n", "there are no triangles in it"},
      {"this is not a mesh\n", "there are no triangles in it"},
  };
  for (const auto& [text, expected] : cases) {
    const TemporaryFile file("bad.obj", text);
    const std::string sentence = refusal([&] { load_scene(file.path()); });
    expect_in(expected, sentence);
    expect_in(file.path(), sentence);
  }
  expect_in("cannot be opened", refusal([] { load_scene("teapt"); }));
  expect_in("is a folder", refusal([] { load_scene("/"); }));
}

TEST(Files, CutOnesAreRefused) {
  std::ifstream whole(kModels + "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb", std::ios::binary);
  std::ostringstream bytes;
  bytes << whole.rdbuf();
  ASSERT_GT(bytes.str().size(), 10000u);
  for (const std::size_t size : {std::size_t(3), std::size_t(200), bytes.str().size() / 2}) {
    const TemporaryFile file("cut.glb", bytes.str().substr(0, size));
    expect_in("cannot be read as a mesh", refusal([&] { load_scene(file.path()); }));
  }
}

TEST(Files, HeadersThatPromiseTooMuchAreRefused) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  const TemporaryFile whole("whole.ply", ply + "3 0 1 2\n"), cut("cut.ply", ply),
      headless("headless.ply", ply.substr(0, 60));
  EXPECT_EQ(load_scene(whole.path()).framing.size(), 3u);
  expect_in("announces 4 elements, but only 3 lines follow", refusal([&] { load_scene(cut.path()); }));
  expect_in("the header has no end", refusal([&] { load_scene(headless.path()); }));
}

}  // namespace
}  // namespace halfspace::ref
