// SPDX-License-Identifier: Apache-2.0
#include "rates.hpp"

namespace halfspace::tb {

const char* const kCountedStreams[6] = {"visible", "stamp", "update", "scan", "planes", "colours"};

namespace {

// Lanes in which the field is not 0, over all words.
std::uint64_t lanes_set(const Vectors& vectors, const std::map<std::string, Words>& received, const char* stream, const char* field) {
  const auto words = received.find(stream);
  if (words == received.end()) return 0;
  const Field& lanes = vectors.find(stream)->need(field, "the data rates");
  std::uint64_t count = 0;
  for (std::size_t n = 0; n < words->second.size(); ++n) {
    for (int lane = 0; lane < lanes.count; ++lane) count += lanes.raw(words->second[n], lane) != 0;
  }
  return count;
}

}  // namespace

Rates count_rates(const Vectors& vectors, const std::map<std::string, Words>& received) {
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
  return rates;
}

}  // namespace halfspace::tb
