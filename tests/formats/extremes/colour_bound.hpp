// SPDX-License-Identifier: Apache-2.0
// What the colour of a pixel may be, from the words of its triangle: the exact one, and every one that the derived
// bounds of light, planes and texture allow.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_COLOUR_BOUND_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_COLOUR_BOUND_HPP_

#include <optional>
#include <unordered_map>
#include <vector>

#include "model/pipeline/named_frame.hpp"
#include "ref/geometry/distant_lighting.hpp"
#include "study/proofs/lighting_bounds.hpp"
#include "study/proofs/phong_bounds.hpp"
#include "study/proofs/texture_bounds.hpp"
#include "tests/formats/extremes/exact_pixel.hpp"

namespace halfspace::tests {

// A range for each channel, of whole numbers as a pixel has them.
struct ColourBox {
  std::array<double, 3> low, high;
  bool holds(const std::array<int, 3>& rgb) const {
    bool inside = true;
    for (std::size_t c = 0; c < 3; ++c) inside = inside && rgb[c] >= low[c] && rgb[c] <= high[c];
    return inside;
  }
};
struct ColourBound {
  std::array<double, 3> exact{};  // before it is rounded, LSB
  std::vector<ColourBox> boxes;   // it lies in one of them; none: nothing is said of it

  // Whether a channel may be two places apart at most, and the exact colour is next to these: not where a highlight
  // is switched between the exact normal and its words.
  bool is_sharp(std::size_t c) const {
    double low = boxes[0].low[c], high = boxes[0].high[c];
    for (const ColourBox& box : boxes) low = std::min(low, box.low[c]), high = std::max(high, box.high[c]);
    return high - low <= 2 && exact[c] > low - 1 && exact[c] < high + 1;
  }
};

constexpr double kTinyShare = 1e-9;

class LightBound {
 public:
  LightBound(const Config& config, const model::LightingFrame& frame) : c_(config), frame_(frame) {
    const double unit = std::ldexp(1.0, -cosine_fraction(config) - 1),
                 coefficient = std::ldexp(1.0, -kCoefficientFraction);
    const auto vector = [](const std::array<int, 3>& v, double scale) { return scale * glm::dvec3(v[0], v[1], v[2]); };
    for (const model::RawLight& light : frame.lights) {
      lights_.push_back({vector(light.to_light, unit), vector(light.half, unit), {1, 1, 1}});
      is_unit_ = is_unit_ && glm::length(lights_.back().to_light) < 1 + 4 * unit &&
                 glm::length(lights_.back().half) < 1 + 4 * unit;
    }
    const double scale = coefficient * 255 / full();
    for (const model::RawMaterial& material : frame.materials) {
      ref::DistantMaterial& out = materials_.emplace_back();
      out.base = glm::dvec3(0), out.squarings = std::min(material.gloss, exact_log2(config.gloss));
      for (const model::RawReflection& r : material.reflections) {
        out.base += vector(r.base, scale);
        out.reflections.push_back({vector(r.diffuse, scale), vector(r.specular, scale)});
      }
    }
  }

  double full() const { return (1 << c_.colour_bits) - 1; }
  // Whether the reference, whose directions have length 1, says something.
  bool is_unit() const { return is_unit_; }
  // Of ref::distant_colour, LSB.
  std::array<double, 3> reference(int material, const std::array<double, 3>& n) const {
    const glm::dvec3 colour =
        ref::distant_colour(materials_[std::size_t(material)], lights_, {n[0], n[1], n[2]}) * full() / 255.0;
    return {colour.x, colour.y, colour.z};
  }
  // The exact sum of a word, not clamped, and its bound.
  model::ExactLight sum(int material, const std::array<int, 3>& n, int channel) const {
    const model::RealNormal real = {(long double)n[0], (long double)n[1], (long double)n[2]};
    return model::exact_light(frame_, material, real, channel, c_);
  }
  // What a word is lit to.
  ColourBound colour(int material, const std::array<int, 3>& n) const {
    ColourBound out;
    ColourBox box;
    for (int c = 0; c < 3; ++c) {
      const model::ExactLight light = sum(material, n, c);
      const double value = double(light.value), bound = double(light.bound) + kTinyShare;
      const std::size_t at = std::size_t(c);
      out.exact[at] = std::clamp(value, 0.0, full());
      box.low[at] = std::clamp(std::floor(value - bound + 0.5), 0.0, full());
      box.high[at] = std::clamp(std::floor(value + bound + 0.5), 0.0, full());
    }
    out.boxes = {box};
    return out;
  }

 private:
  const Config c_;
  const model::LightingFrame& frame_;
  std::vector<ref::DistantLight> lights_;
  std::vector<ref::DistantMaterial> materials_;
  bool is_unit_ = true;
};

// Before texture: the colour of a vertex, a plane of colours, or the light on a plane of normals.
class ShadeBound {
 public:
  ShadeBound(const Config& config, const model::NamedFrame& frame)
      : c_(config), frame_(frame), light_(config, frame.lighting) {}

  ColourBound at(std::uint32_t k, const ExactPixel& pixel) const {
    if (is_phong(c_)) return phong(frame_.lighting.triangles[k - 1], pixel);
    std::array<ColourBound, 3> vertex;
    for (int v = 0; v < 3; ++v) vertex[std::size_t(v)] = of_vertex(k, v);
    if (!is_gouraud(c_)) return vertex[0];
    ColourBound out;
    ColourBox box;
    const double plane = std::ldexp(1.0, c_.colour_bits - c_.reciprocal_bits) +
                         std::ldexp(pixel.distance() / 2 + 1, -c_.colour_fraction) + kTinyShare;
    for (std::size_t c = 0; c < 3; ++c) {
      std::array<double, 3> exact, low, high;
      for (std::size_t v = 0; v < 3; ++v)
        exact[v] = vertex[v].exact[c], low[v] = vertex[v].boxes[0].low[c], high[v] = vertex[v].boxes[0].high[c];
      out.exact[c] = pixel.plane(exact);
      box.low[c] = std::max(std::floor(pixel.plane(low) - plane + 0.5), 0.0);
      box.high[c] = std::min(std::floor(pixel.plane(high) + plane + 0.5), light_.full());
    }
    out.boxes = {box};
    return out;
  }

 private:
  ColourBound of_vertex(std::uint32_t k, int v) const {
    if (has_lighting(c_)) {
      const model::RawNormals& n = frame_.lighting.triangles[k - 1];
      return light_.colour(n.material, n.normals[std::size_t(v)]);
    }
    ColourBound out;
    for (std::size_t c = 0; c < 3; ++c) out.exact[c] = frame_.scene.triangles[k - 1].rgb[std::size_t(v)][c];
    out.boxes = {{out.exact, out.exact}};
    return out;
  }

  // One of the words around the exact normal is lit.
  ColourBound phong(const model::RawNormals& given, const ExactPixel& pixel) const {
    // Of one normal all over the triangle, that word: directions may be longer than the reference has them.
    const auto& n = given.normals;
    if (n[0] == n[1] && n[1] == n[2]) return light_.colour(given.material, n[0]);
    const double reach = 0.5 + model::normal_plane_bound(c_, pixel.distance()) + kTinyShare;
    std::array<std::vector<int>, 3> words;
    std::array<double, 3> exact;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<int, 3> of_vertex{n[0][c], n[1][c], n[2][c]};
      exact[c] = pixel.plane(of_vertex);
      if (is_constant(of_vertex)) words[c] = {n[0][c]};
      else
        for (int w = int(std::ceil(exact[c] - reach)); w <= int(std::floor(exact[c] + reach)); ++w)
          words[c].push_back(w);
    }
    ColourBound out;
    for (const int x : words[0]) {
      for (const int y : words[1]) {
        for (const int z : words[2]) out.boxes.push_back(light_.colour(given.material, {x, y, z}).boxes[0]);
      }
    }
    out.exact = light_.reference(given.material, exact);
    return out;
  }

  const Config c_;
  const model::NamedFrame& frame_;
  const LightBound light_;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_COLOUR_BOUND_HPP_
