// SPDX-License-Identifier: Apache-2.0
// Configurations that nobody named, of random numbers, accepted.
#ifndef HALFSPACE_TESTS_FORMATS_RANDOM_CONFIG_HPP_
#define HALFSPACE_TESTS_FORMATS_RANDOM_CONFIG_HPP_

#include <random>

#include "hls/formats/refusal.hpp"

namespace halfspace::tests {

class RandomConfigs {
 public:
  explicit RandomConfigs(std::uint64_t seed) : random_(seed) {}

  // Without lighting, texture, motion or objects; geometry culls, and gives the indices.
  Config plain() {
    return accepted([this](Config& c) {
      if (one_in(4)) c.depth_bits = c.depth_fraction = 0;
      if (one_in(4)) c.shading = Shading::kFlat, c.colour_fraction = 0;
    });
  }

  // With features in turn, and in what they can be combined with.
  Config next() {
    switch (turn_++ % 8) {
      case 0: return plain();
      case 1: return accepted([this](Config& c) { gamma(c); });
      case 2: return accepted([this](Config& c) { light(c), objects(c); });
      case 3: return accepted([this](Config& c) { phong(c), objects(c); });
      case 4: return accepted([this](Config& c) { texture(c), objects(c); });
      case 5: return accepted([this](Config& c) { one_in(2) ? light(c) : phong(c), texture(c), gamma(c); });
      case 6: return accepted([this](Config& c) { motion(c); });
      default:
        return accepted([this](Config& c) {
          c.object_bits = in(1, 22);
          c.cull = Cull(in(0, 2));
          c.index_window = one_in(2) ? in(1, 64) : 0;
        });
    }
  }

 private:
  int in(int low, int high) { return low + int(random_() % std::uint64_t(high - low + 1)); }
  bool one_in(int n) { return in(1, n) == 1; }

  Config numbers() {
    Config c{};
    c.name = "random";
    c.width = in(1, 400), c.height = in(1, 300);
    c.triangles = in(100, 5000);
    c.range_bits = in(5, 14), c.subpixel_bits = in(1, 10);
    c.depth_bits = in(2, 32), c.colour_bits = in(1, 8);
    c.reciprocal_bits = in(8, 38), c.depth_fraction = in(5, 25), c.colour_fraction = in(5, 25);
    c.lanes = 1 << in(0, 4);
    return c;
  }
  template <class Change>
  Config accepted(Change change) {
    for (;;) {
      Config c = numbers();
      change(c);
      if (!has_planes(c)) c.reciprocal_bits = 0;
      if (refusal(c) == Refusal::kNone) return c;
    }
  }

  void gamma(Config& c) { c.architecture = one_in(2) && c.depth_bits ? Architecture::kGamma : Architecture::kDelta; }
  void objects(Config& c) {
    if (one_in(2)) c.object_bits = in(1, 22);
  }
  void light(Config& c) {
    c.normal_bits = in(9, 16), c.lights = in(1, 4), c.materials = in(1, 40);
    c.gloss = one_in(4) ? 0 : 1 << in(0, 4);
    if (one_in(3)) c.shading = Shading::kFlat, c.colour_fraction = 0;
  }
  void phong(Config& c) {
    light(c);
    c.shading = Shading::kPhong, c.colour_fraction = 0;
    c.normal_fraction = in(8, 22);
  }
  void coordinates(Config& c) {
    c.mapping = one_in(2) ? TextureMapping::kAffine : TextureMapping::kPerspective;
    c.coordinate_bits = in(10, 24), c.coordinate_fraction = in(8, 20);
  }
  void texture(Config& c) {
    coordinates(c);
    c.texture = one_in(2) ? TextureFilter::kNearest : TextureFilter::kBilinear;
    c.texels = 1 << in(2, 16), c.textures = in(1, 40);
  }
  void motion(Config& c) {
    coordinates(c);
    c.shading = Shading::kMotion;
    c.filter = KeyFilter(in(1, 4));
    c.vector_range = in(1, 11), c.vector_fraction = in(1, 8), c.weight_bits = in(2, 8);
    c.face_bits = in(1, 22), c.samples = 1 << in(0, 2);
    c.relight = in(0, 1);
    if (!c.relight) c.colour_fraction = 0;
    gamma(c);
  }

  std::mt19937_64 random_;
  int turn_ = 0;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_RANDOM_CONFIG_HPP_
