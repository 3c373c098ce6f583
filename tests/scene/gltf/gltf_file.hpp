// SPDX-License-Identifier: Apache-2.0
// Tiny glTF files, written and read.
#ifndef HALFSPACE_TESTS_SCENE_GLTF_GLTF_FILE_HPP_
#define HALFSPACE_TESTS_SCENE_GLTF_GLTF_FILE_HPP_

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ref/scene/gltf/read_gltf.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {

using nlohmann::json;

inline std::string base64(const std::string& bytes) {
  static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kDigits[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

template <class Number>
constexpr int component_type() {
  if (std::is_same_v<Number, std::int8_t>) return 5120;
  if (std::is_same_v<Number, std::uint8_t>) return 5121;
  if (std::is_same_v<Number, std::int16_t>) return 5122;
  if (std::is_same_v<Number, std::uint16_t>) return 5123;
  return std::is_same_v<Number, std::uint32_t> ? 5125 : 5126;
}

// A triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) at node 0, without indices and normals: accessor 0.
class GltfFile {
 public:
  GltfFile() {
    root = json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                           "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                           "accessors": [], "bufferViews": []})");
    add<float>("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  }

  template <class Number>
  int add_view(const std::vector<Number>& numbers) {
    bytes.resize((bytes.size() + 3) / 4 * 4);
    const std::size_t at = bytes.size(), size = numbers.size() * sizeof(Number);
    bytes.resize(at + size);
    std::memcpy(&bytes[at], numbers.data(), size);
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", size}});
    return int(root["bufferViews"].size()) - 1;
  }
  // The number of the accessor.
  template <class Number>
  int add(const std::string& type, int count, const std::vector<Number>& numbers, bool normalized = false) {
    json accessor{{"bufferView", add_view(numbers)},
                  {"componentType", component_type<Number>()},
                  {"count", count},
                  {"type", type}};
    if (normalized) accessor["normalized"] = true;
    root["accessors"].push_back(accessor);
    return int(root["accessors"].size()) - 1;
  }
  void attribute(const std::string& name, int accessor) { primitive()["attributes"][name] = accessor; }
  // One way, so that the faces are not flat and vertices stay shared.
  void add_normals(int count) {
    std::vector<float> normals(std::size_t(3 * count), 0);
    for (int i = 0; i < count; ++i) normals[std::size_t(3 * i + 2)] = 1;
    attribute("NORMAL", add("VEC3", count, normals));
  }
  json& primitive() { return root["meshes"][0]["primitives"][0]; }
  json& material() {
    primitive()["material"] = 0;
    return root["materials"][0];
  }
  // A picture of 2×1 texels, red and green, as texture 0.
  void add_picture() {
    root["images"].push_back({{"uri", std::string("data:image/png;base64,") + kRedGreen}});
    root["textures"].push_back({{"source", 0}});
  }

  std::string text() const {
    json whole = root;
    if (!bytes.empty() && !whole.contains("buffers")) {
      whole["buffers"].push_back(
          {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}});
    }
    return whole.dump();
  }
  Document read(bool textured = false) const {
    const TemporaryFile file("made.gltf", text());
    return read_gltf(file.path(), {textured});
  }
  // The sentence that it is refused with.
  std::string refused() const {
    return refusal([&] { read(); });
  }

  json root;
  std::string bytes;

 private:
  static constexpr const char* kRedGreen =
      "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR4nGP4z8DA8J8BAAf/Af8Bf4mnAAAAAElFTkSuQmCC";
};

}  // namespace halfspace::ref

#endif  // HALFSPACE_TESTS_SCENE_GLTF_GLTF_FILE_HPP_
