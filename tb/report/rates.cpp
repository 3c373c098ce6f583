// SPDX-License-Identifier: Apache-2.0
#include "tb/report/rates.hpp"

namespace halfspace::tb {

const char* const kCountedStreams[9] = {"setup",  "visible", "stamp",          "update",       "scan",
                                        "planes", "colours", "texture_planes", "motion_planes"};

namespace {

// Lanes in which the field is not 0, over all words.
std::uint64_t lanes_set(const Vectors& vectors, const std::map<std::string, Words>& received, const char* stream,
                        const char* field) {
  const auto words = received.find(stream);
  if (words == received.end()) return 0;
  const Field& lanes = vectors.find(stream)->need(field, "the data rates");
  std::uint64_t count = 0;
  for (std::size_t n = 0; n < words->second.size(); ++n) {
    for (int lane = 0; lane < lanes.count; ++lane) count += lanes.raw(words->second[n], lane) != 0;
  }
  return count;
}

// Pixels of triangles that have a texture. An index stands for the triangle that was stored last.
std::uint64_t textured_pixels(const Vectors& vectors, const std::map<std::string, Words>& received) {
  const auto planes = received.find("texture_planes"), scan = received.find("scan");
  if (planes == received.end() || scan == received.end()) return 0;
  const auto field = [&](const char* stream, const char* name) -> const Field& {
    return vectors.find(stream)->need(name, "the data rates");
  };
  std::map<std::uint64_t, bool> has_texture;
  for (std::size_t n = 0; n < planes->second.size(); ++n) {
    const std::uint32_t* const word = planes->second[n];
    if (field("texture_planes", "empty").raw(word)) continue;
    has_texture[field("texture_planes", "index").raw(word)] = field("texture_planes", "texture").raw(word) != 0;
  }
  const Field& index = field("scan", "index");
  std::uint64_t count = 0;
  for (std::size_t n = 0; n < scan->second.size(); ++n) {
    for (int lane = 0; lane < index.count; ++lane) {
      const auto found = has_texture.find(index.raw(scan->second[n], lane));
      count += found != has_texture.end() && found->second;
    }
  }
  return count;
}

}  // namespace

Rates count_rates(const Vectors& vectors, const std::map<std::string, Words>& received, int texels) {
  Rates rates;
  rates.triangles = lanes_set(vectors, received, "visible", "index");  // 0: a frame without triangles
  rates.reduced_triangles = lanes_set(vectors, received, "visible", "visible");
  rates.fragments = lanes_set(vectors, received, "stamp", "mask");
  rates.reduced_fragments = lanes_set(vectors, received, "update", "mask");
  rates.visible_pixels = lanes_set(vectors, received, "scan", "index");
  rates.lights = vectors.find("normals") != nullptr;
  if (const Stream* const colours = vectors.find("colours")) {
    rates.lightings = lanes_set(vectors, received, "colours", "index") * (colours->find("r0") ? 3 : 1);
  } else if (rates.lights) {
    rates.lightings = rates.visible_pixels;
  }
  rates.textures = vectors.find("texture_planes") != nullptr;
  rates.texture_fetches = textured_pixels(vectors, received) * std::uint64_t(texels);
  return rates;
}

}  // namespace halfspace::tb
