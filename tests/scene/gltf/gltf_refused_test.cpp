// SPDX-License-Identifier: Apache-2.0
// glTF files that the specification forbids, or that are too much: each is refused with a sentence.
#include <cmath>
#include <functional>

#include "tests/scene/gltf/gltf_file.hpp"

namespace halfspace::ref {
namespace {

struct Case {
  const char* sentence;
  std::function<void(GltfFile&)> spoil;
};

void expect_refused(const std::vector<Case>& cases) {
  for (const Case& of : cases) {
    GltfFile file;
    ASSERT_EQ(file.read().meshes.size(), 1u);
    of.spoil(file);
    expect_in(of.sentence, file.refused());
  }
}

TEST(GltfRefused, NumbersBeyondWhatTheFileHolds) {
  expect_refused({
      {"which its buffer view does not hold", [](GltfFile& f) { f.root["accessors"][0]["count"] = 4; }},
      {"which its buffer view does not hold", [](GltfFile& f) { f.root["accessors"][0]["count"] = 1ull << 52; }},
      {"which its buffer view does not hold", [](GltfFile& f) { f.root["accessors"][0]["byteOffset"] = 4; }},
      {"accessors[0].byteOffset is not a whole number", [](GltfFile& f) { f.root["accessors"][0]["byteOffset"] = -4; }},
      {"accessors[0].count is not a whole number", [](GltfFile& f) { f.root["accessors"][0]["count"] = 1e300; }},
      {"elements without a buffer",
       [](GltfFile& f) {
         f.root["accessors"][0].erase("bufferView");
         f.root["accessors"][0]["count"] = 400000000;
       }},
      {"goes beyond the 36 bytes of its buffer", [](GltfFile& f) { f.root["bufferViews"][0]["byteLength"] = 37; }},
      {"goes beyond the 36 bytes of its buffer",
       [](GltfFile& f) { f.root["bufferViews"][0]["byteOffset"] = 9007199254740991; }},
      {"says that it has 40 bytes and has 36",
       [](GltfFile& f) {
         f.root["buffers"] = {{{"byteLength", 40}, {"uri", "data:application/octet-stream;base64," + base64(f.bytes)}}};
       }},
      {"its buffer 'no.bin' is not there",
       [](GltfFile& f) {
         f.root["buffers"] = {{{"byteLength", 40}, {"uri", "no.bin"}}};
       }},
      {"bufferViews[0].byteStride is not a whole number from 4 to 252",
       [](GltfFile& f) { f.root["bufferViews"][0]["byteStride"] = 0; }},
      {"has elements of 12 bytes every 8", [](GltfFile& f) { f.root["bufferViews"][0]["byteStride"] = 8; }},
      {"index 3, beyond 3 vertices",
       [](GltfFile& f) {
         f.primitive()["indices"] = f.add<std::uint8_t>("SCALAR", 3, {0, 1, 3});
       }},
      {"is not of unsigned numbers",
       [](GltfFile& f) {
         f.primitive()["indices"] = f.add<std::uint8_t>("SCALAR", 3, {0, 1, 2}, true);
       }},
      {"2 corners are no whole triangles",
       [](GltfFile& f) {
         f.primitive()["indices"] = f.add<std::uint8_t>("SCALAR", 2, {0, 1});
       }},
      {"has 2 elements beside 3 positions",
       [](GltfFile& f) { f.attribute("NORMAL", f.add<float>("VEC3", 2, std::vector<float>(6, 1))); }},
      {"has 2 numbers an element",
       [](GltfFile& f) { f.attribute("POSITION", f.add<float>("VEC2", 3, std::vector<float>(6, 1))); }},
      {"has NaN or infinity as element 1",
       [](GltfFile& f) {
         f.attribute("POSITION", f.add<float>("VEC3", 3, {0, 0, 0, 0, NAN, 0, 0, 0, 0}));
       }},
      {"has NaN or infinity",
       [](GltfFile& f) { f.attribute("NORMAL", f.add<float>("VEC3", 3, std::vector<float>(9, INFINITY))); }},
  });
}

TEST(GltfRefused, SparseElementsThatAreNotThere) {
  const auto sparse = [](GltfFile& f, std::vector<std::uint8_t> at, int count) {
    const int places = f.add_view(at), values = f.add_view(std::vector<float>(3 * at.size(), 1));
    f.root["accessors"][0]["sparse"] = {{"count", count},
                                        {"indices", {{"bufferView", places}, {"componentType", 5121}}},
                                        {"values", {{"bufferView", values}}}};
  };
  expect_refused({
      {"replaces element 3, and has 3",
       [&](GltfFile& f) {
         sparse(f, {0, 3}, 2);
       }},
      {"sparse indices that do not rise",
       [&](GltfFile& f) {
         sparse(f, {1, 1}, 2);
       }},
      {"which its buffer view does not hold",
       [&](GltfFile& f) {
         sparse(f, {0, 1}, 3);
       }},
      {"replaces more elements than it has",
       [&](GltfFile& f) {
         sparse(f, {0, 1, 2, 3}, 4);
       }},
  });
}

TEST(GltfRefused, WhatIsReferredToAndNotThere) {
  expect_refused({
      {"nodes[0].mesh is not one of the 1 meshes", [](GltfFile& f) { f.root["nodes"][0]["mesh"] = 1; }},
      {"nodes[0].mesh is not one of the 1 meshes", [](GltfFile& f) { f.root["nodes"][0]["mesh"] = "0"; }},
      {"nodes[0].mesh is not one of the 1 meshes", [](GltfFile& f) { f.root["nodes"][0]["mesh"] = 4294967296; }},
      {"scenes[0].nodes[0] is not one of the 1 nodes", [](GltfFile& f) { f.root["scenes"][0]["nodes"] = {-1}; }},
      {"nodes is not a list",
       [](GltfFile& f) {
         f.root["nodes"] = {{"a", 1}};
       }},
      {"accessors[0].type is missing", [](GltfFile& f) { f.root["accessors"][0].erase("type"); }},
      {"nodes[0].matrix is not a list of 16 numbers",
       [](GltfFile& f) {
         f.root["nodes"][0]["matrix"] = {1, 2, 3};
       }},
      {"nodes[0].scale[1] is not a number",
       [](GltfFile& f) {
         f.root["nodes"][0]["scale"] = {1, "1", 1};
       }},
      {"is moved by joint 2 of 1",
       [](GltfFile& f) {
         f.attribute("JOINTS_0", f.add<std::uint8_t>("VEC4", 3, std::vector<std::uint8_t>(12, 2)));
         f.attribute("WEIGHTS_0", f.add<float>("VEC4", 3, std::vector<float>(12, 0.25)));
         f.root["skins"] = {{{"joints", {0}}}};
         f.root["nodes"][0]["skin"] = 0;
       }},
  });
}

TEST(GltfRefused, NodesThatAreNoTree) {
  expect_refused({
      {"is in a circle", [](GltfFile& f) { f.root["nodes"][0]["children"] = {0}; }},
      {"is a child of node 0 and of node 0",
       [](GltfFile& f) { f.root["nodes"] = json::parse(R"([{"children": [1, 1]}, {"mesh": 0}])"); }},
      {"twice in the scene",
       [](GltfFile& f) {
         f.root["scenes"][0]["nodes"] = {0, 0};
       }},
      {"nested more than 1000 deep",
       [](GltfFile& f) {
         for (int i = 0; i < 20000; ++i) f.root["nodes"][std::size_t(i)] = {{"children", {i + 1}}};
         f.root["nodes"].push_back({{"mesh", 0}});
       }},
  });
}

TEST(GltfRefused, ExtensionsAndVersionsThatAreNotRead) {
  expect_refused({
      {"requires the extension EXT_x, which is not drawn",
       [](GltfFile& f) { f.root["extensionsUsed"] = f.root["extensionsRequired"] = {"EXT_x"}; }},
      {"is compressed by KHR_draco_mesh_compression",
       [](GltfFile& f) {
         f.root["accessors"][0].erase("bufferView");
         f.primitive()["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0}};
       }},
      {"asks for a reader of glTF '3.0'", [](GltfFile& f) { f.root["asset"]["version"] = "3.0"; }},
      {"asks for a reader of glTF '2.1'", [](GltfFile& f) { f.root["asset"]["minVersion"] = "2.1"; }},
      {"there is no asset", [](GltfFile& f) { f.root.erase("asset"); }},
  });
  GltfFile old;
  old.root["asset"]["version"] = "1.0";
  EXPECT_THROW(old.read(), FirstGltf);
  GltfFile used;
  used.root["extensionsUsed"] = {"EXT_x", "KHR_materials_unlit", "EXT_y"};
  EXPECT_EQ(used.read().remarks, std::vector<std::string>{"drawn without what these extensions add: EXT_x, EXT_y"});
}

TEST(GltfRefused, AnimationsThatAreNone) {
  const auto animate = [](GltfFile& f, std::vector<float> times, std::vector<float> values, const char* path) {
    const std::string type = path == std::string("rotation") ? "VEC4" : "VEC3";
    const int count = int(values.size()) / (type == "VEC4" ? 4 : 3);
    f.root["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}},
         {"samplers",
          {{{"input", f.add("SCALAR", int(times.size()), times)}, {"output", f.add(type, count, values)}}}}}};
  };
  expect_refused({
      {"falls at element 1",
       [&](GltfFile& f) {
         animate(f, {1, 0}, std::vector<float>(6, 1), "scale");
       }},
      {"has NaN or infinity",
       [&](GltfFile& f) {
         animate(f, {0, NAN}, std::vector<float>(6, 1), "scale");
       }},
      {"has 1 elements for 2 keys, not 2",
       [&](GltfFile& f) {
         animate(f, {0, 1}, {1, 1, 1}, "scale");
       }},
      {"rotation of length 0",
       [&](GltfFile& f) {
         animate(f, {0}, {0, 0, 0, 0}, "rotation");
       }},
      {"has no sampler 5",
       [&](GltfFile& f) {
         animate(f, {0}, {1, 1, 1}, "scale");
         f.root["animations"][0]["channels"][0]["sampler"] = 5;
       }},
  });
}

TEST(GltfRefused, FilesThatAreCutOrNoJson) {
  const auto sentence = [](const std::string& bytes) {
    const TemporaryFile file("cut.glb", bytes);
    return refusal([&] { read_gltf(file.path(), {}); });
  };
  const std::string text = GltfFile().text();
  expect_in("cannot be read as a mesh", sentence(text.substr(0, text.size() / 2)));
  expect_in("nested more than 100 deep", sentence(std::string(200000, '[')));
  const auto word = [](std::size_t n) { return std::string(reinterpret_cast<const char*>(&n), 4); };
  std::string padded = text + std::string(3 - (text.size() + 3) % 4, ' ');
  const std::string glb = "glTF" + word(2) + word(20 + padded.size()) + word(padded.size()) + "JSON" + padded;
  EXPECT_EQ(sentence(glb), "(not refused)");
  for (const std::size_t size : {std::size_t(4), std::size_t(19), std::size_t(30), glb.size() - 1}) {
    expect_in("cannot be read as a mesh", sentence(glb.substr(0, size)));
  }
  expect_in("is GLB of version 3", sentence("glTF" + word(3) + glb.substr(8)));
  const TemporaryFile first("first.glb", "glTF" + word(1) + glb.substr(8));
  EXPECT_THROW(read_gltf(first.path(), {}), FirstGltf);
}

}  // namespace
}  // namespace halfspace::ref
