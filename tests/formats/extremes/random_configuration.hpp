// SPDX-License-Identifier: Apache-2.0
// Configurations that nobody named, of all features. Colours of 4 bits, texture memories of 32 texels and frames of 48
// pixels each way are the least in which an extreme can show.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_RANDOM_CONFIGURATION_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_RANDOM_CONFIGURATION_HPP_

#include <random>
#include <string>
#include <vector>

#include "model/formats/configuration.hpp"
#include "tests/formats/extremes/feature_configurations.hpp"

namespace halfspace::tests {

class RandomConfiguration {
 public:
  explicit RandomConfiguration(unsigned seed) : random_(seed) {}

  // The next that is accepted, and has something besides the base pipeline.
  model::Configuration next() {
    Config c = any();
    while (refusal(c) != Refusal::kNone || !has_feature(c)) c = any();
    return model::Configuration("random", c);
  }

 private:
  int in(int low, int high) { return low + int(random_() % unsigned(high - low + 1)); }
  bool maybe() { return in(0, 1) == 1; }

  Config any() {
    Config c{};
    c.name = "random";
    c.width = in(48, 200), c.height = in(48, 120), c.triangles = in(100, 3000);
    c.range_bits = in(8, 13), c.subpixel_bits = in(1, 10), c.colour_bits = in(4, 8), c.lanes = 1 << in(0, 4);
    c.reciprocal_bits = in(14, 38);
    if (in(0, 4) != 0) c.depth_bits = in(3, 26), c.depth_fraction = in(8, 22);
    const Shading shadings[] = {Shading::kGouraud, Shading::kFlat, Shading::kPhong, Shading::kMotion};
    c.shading = shadings[in(0, 3)];
    if (has_motion(c)) add_motion(c);
    else {
      if (is_phong(c) || maybe()) add_light(c);
      if (maybe()) add_texture(c);
      if (maybe()) c.object_bits = in(1, 22);
    }
    if (is_gouraud(c) || relights(c)) c.colour_fraction = in(8, 22);
    return c;
  }
  void add_light(Config& c) {
    c.normal_bits = in(9, 16), c.lights = in(1, 4), c.gloss = in(0, 3) ? 1 << in(0, 4) : 0, c.materials = in(1, 64);
    if (is_phong(c)) c.normal_fraction = in(10, 22);
  }
  void add_coordinates(Config& c) {
    c.mapping = maybe() ? TextureMapping::kPerspective : TextureMapping::kAffine;
    c.coordinate_bits = in(10, 24), c.coordinate_fraction = in(8, 22);
  }
  void add_texture(Config& c) {
    add_coordinates(c);
    c.texture = maybe() ? TextureFilter::kBilinear : TextureFilter::kNearest;
    c.texels = 1 << in(5, 14), c.textures = in(1, 64);
  }
  void add_motion(Config& c) {
    add_coordinates(c);
    c.filter = KeyFilter(in(int(KeyFilter::kNearest), int(KeyFilter::kBicubic)));
    c.vector_range = in(1, 13), c.vector_fraction = in(1, 8), c.weight_bits = in(2, 8), c.face_bits = in(1, 20);
    c.relight = in(0, 1), c.samples = 1 << in(0, 2);
  }

  std::mt19937 random_;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_RANDOM_CONFIGURATION_HPP_
