// SPDX-License-Identifier: Apache-2.0
// Frames of triangles that stand in cells beside each other, each with its normals; and what lights them.
#ifndef HALFSPACE_VECTORS_FRAMES_FEATURES_LIGHT_BUILDER_HPP_
#define HALFSPACE_VECTORS_FRAMES_FEATURES_LIGHT_BUILDER_HPP_

#include <algorithm>
#include <string>
#include <vector>

#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {

// A triangle a cell of `cell` pixels each way, with vertices on the centres of its corners' pixels; as many frames as
// it takes. `put(frame, k, first)` is called for cell k, which begins at pixel `first`.
template <class Put>
void push_cells(std::vector<NamedFrame>& frames, const std::string& note, const ref::RasterFormat& format, int cells,
                int cell, const NamedFrame& with, Put put) {
  const int columns = std::max(std::min(format.width, 48) / cell, 1),
            rows = std::max(std::min(format.height, 40) / cell, 1);
  const int most = std::min(columns * rows, format.triangles);
  for (int from = 0; from < cells; from += most) {
    FrameBuilder b(format, std::min(columns, cells) * cell,
                   (std::min(most, cells - from) + columns - 1) / columns * cell);
    NamedFrame frame = with;
    frame.note = note;
    for (int k = from; k < std::min(from + most, cells); ++k) {
      const int x = (k - from) % columns * cell, y = (k - from) / columns * cell;
      b.add({b.centre(x), b.centre(y)}, {b.centre(x + cell - 1), b.centre(y)}, {b.centre(x), b.centre(y + cell - 1)});
      for (auto& rgb : b.back().rgb) rgb.fill(b.colour(255));
      put(frame, k, Point{x, y});
    }
    frame.scene = b.list();
    frames.push_back(std::move(frame));
  }
}

// The numbers of lighting: p, u, and words of directions and coefficients.
class LightBuilder {
 public:
  using Normal = std::array<int, 3>;

  explicit LightBuilder(const Config& config) : config_(config), table_(format_table(config)) {}

  int most() const { return (1 << config_.normal_bits) - 1; }
  int least() const { return -most() - 1; }
  int far() const { return (1 << (table_.direction.width - 1)) - 1; }  // all but 1
  int full_coefficient() const { return (1 << table_.coefficient.width) - 1; }
  // LSB of the colour.
  int coefficient(double lsb) const {
    return int(std::clamp(lsb * (1 << kCoefficientFraction) + 0.5, 0.0, double(full_coefficient())));
  }
  int full_colour() const { return (1 << config_.colour_bits) - 1; }
  int squarings() const { return exact_log2(config_.gloss); }
  // What a word of a material can say: more than is built counts as the largest that is.
  int most_gloss() const { return (1 << table_.gloss.width) - 1; }
  // Terms of a sum: of each light base, diffuse, and with gloss specular.
  int terms() const { return (has_gloss(config_) ? 3 : 2) * config_.lights; }
  // 2^(head − 1) of the sum of a light, LSB.
  int half_sum() const { return 1 << (table_.light_sum.integer - 1); }

  // Every term the same, or base alone, LSB.
  RawMaterial material(int gloss, double base, double diffuse, double specular) const {
    RawMaterial out{gloss, {}};
    for (int i = 0; i < config_.lights; ++i) {
      const int b = coefficient(base), d = coefficient(diffuse), s = has_gloss(config_) ? coefficient(specular) : 0;
      out.reflections.push_back({{b, b, b}, {d, d, d}, {s, s, s}});
    }
    return out;
  }
  // Whose terms, all in white and at their largest, sum up to 2^(head − 1) exactly; where no terms do, they are full.
  RawMaterial half_sum_material() const {
    RawMaterial out = material(0, 0, 0, 0);
    const std::int64_t sum = std::int64_t(half_sum()) << kCoefficientFraction;
    for (int n = 0; n < terms(); ++n) {
      const int value = int(std::min<std::int64_t>((sum + n) / terms(), full_coefficient()));
      RawReflection& r = out.reflections[std::size_t(n % config_.lights)];
      (n < config_.lights ? r.base : n < 2 * config_.lights ? r.diffuse : r.specular).fill(value);
    }
    return out;
  }
  // As many as the table has rows.
  std::vector<RawMaterial> fitted(std::vector<RawMaterial> materials) const {
    materials.resize(std::min(materials.size(), std::size_t(config_.materials)));
    return materials;
  }
  // White whatever shines: a base of full scale in light 0.
  RawMaterial white() const {
    RawMaterial out = material(0, 0, 0, 0);
    out.reflections[0].base.fill(coefficient(full_colour()));
    return out;
  }
  // Along the axes in turn, highlights along the next; each light of its own colour in colourful().
  std::vector<RawLight> axes() const {
    const Normal ways[4] = {{0, 0, far()}, {far(), 0, 0}, {0, -far() - 1, 0}, {far() / 5 * 3, 0, far() / 5 * 4}};
    std::vector<RawLight> out;
    for (int i = 0; i < config_.lights; ++i) out.push_back({ways[i % 4], ways[(i + 1) % 4]});
    return out;
  }
  RawMaterial colourful(int gloss) const {
    RawMaterial out = material(gloss, 0, 0, 0);
    const double share = double(full_colour()) / config_.lights / 2.5;
    for (int i = 0; i < config_.lights; ++i) {
      for (int c = 0; c < 3; ++c) {
        out.reflections[std::size_t(i)].base[c] = coefficient(share / 4);
        out.reflections[std::size_t(i)].diffuse[c] = coefficient((c + i) % 3 == 2 ? share / 3 : share);
        if (has_gloss(config_))
          out.reflections[std::size_t(i)].specular[c] = coefficient((c + i) % 3 ? share : share / 2);
      }
    }
    return out;
  }

 private:
  const Config config_;
  const FormatTable table_;
};

inline void add_normals(LightingFrame& frame, int material, const LightBuilder::Normal& a,
                        const LightBuilder::Normal& b, const LightBuilder::Normal& c) {
  frame.triangles.push_back({int(frame.triangles.size()) + 1, material, {a, b, c}});
}

}  // namespace halfspace::model

#endif  // HALFSPACE_VECTORS_FRAMES_FEATURES_LIGHT_BUILDER_HPP_
