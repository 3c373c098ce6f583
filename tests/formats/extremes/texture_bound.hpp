// SPDX-License-Identifier: Apache-2.0
// What texture makes of the colours that a pixel may have before it.
#ifndef HALFSPACE_TESTS_FORMATS_EXTREMES_TEXTURE_BOUND_HPP_
#define HALFSPACE_TESTS_FORMATS_EXTREMES_TEXTURE_BOUND_HPP_

#include "ref/error.hpp"
#include "ref/scene/texture.hpp"
#include "tests/formats/extremes/colour_bound.hpp"
#include "tests/formats/extremes/place_bound.hpp"

namespace halfspace::tests {

class TextureBound {
 public:
  TextureBound(const Config& config, const model::NamedFrame& frame) : c_(config), frame_(frame) {
    for (const model::RawTexel& texel : frame.texture.texels) memory_[texel.address] = texel.rgb;
    for (const model::RawTexture& t : frame.texture.textures) whole_.push_back(whole(t));
  }

  // `lit` of triangle k, with texture.
  ColourBound at(std::uint32_t k, const ExactPixel& pixel, const ColourBound& lit) const {
    const model::RawCoordinates& words = frame_.texture.triangles[k - 1];
    if (words.texture == 0) return lit;
    const model::RawTexture& texture = frame_.texture.textures[std::size_t(words.texture) - 1];
    std::array<double, 2> where, error;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const int side = axis ? texture.log2_height : texture.log2_width;
      const Place part = exact_part(c_, axis ? words.t : words.s, words.q, pixel);
      const double span = std::ldexp(1.0, side + words.repeats);
      where[axis] = part.at * span - (is_bilinear(c_) ? 0.5 : 0);
      error[axis] = part.error * span + model::texture_cut_bound(c_) + kTinyShare * (1 + part.at * span);
      // A place is anywhere, or among so many texels that it says nothing.
      if (error[axis] > 1.5 && error[axis] >= std::ldexp(1.0, side) / 2) return {};
      if (error[axis] > kMost) return {};
    }
    // The texel of the reference, exactly.
    const ref::Texture& all = whole_[std::size_t(words.texture) - 1];
    std::array<double, 3> exact = interpolated(texture, where);
    if (!all.texels.empty()) {
      std::uint64_t texels = 0;
      const double half = is_bilinear(c_) ? 0.5 : 0;
      const glm::dvec3 rgb =
          ref::sample(all, {(where[0] + half) / all.width, (where[1] + half) / all.height},
                      is_bilinear(c_) ? ref::TextureFilter::kBilinear : ref::TextureFilter::kNearest, texels);
      exact = {rgb.r, rgb.g, rgb.b};
    }
    ColourBound out =
        is_bilinear(c_) ? bilinear(texture, where, error, exact, lit) : nearest(texture, where, error, lit);
    for (std::size_t c = 0; c < 3; ++c) out.exact[c] = lit.exact[c] * exact[c] / full();
    return out;
  }

 private:
  static constexpr double kMost = 8;
  using Rgb = std::array<std::uint8_t, 3>;

  // TextureMemory: in banks by the parity of column and row for a bilinear filter.
  const Rgb& texel(const model::RawTexture& t, std::int64_t column, std::int64_t row) const {
    const int i = int(column & ((1 << t.log2_width) - 1)), j = int(row & ((1 << t.log2_height) - 1));
    const int inside = is_bilinear(c_) ? 4 * (((j >> 1) << t.log2_width >> 1) + (i >> 1)) + 2 * (j & 1) + (i & 1)
                                       : (j << t.log2_width) + i;
    const auto found = memory_.find(t.base + inside);
    if (found == memory_.end()) throw ref::Error(frame_.note + ": a texel that is not there is asked for");
    return found->second;
  }

  // As the reference takes it; without texels where some are not in the memory.
  ref::Texture whole(const model::RawTexture& t) const {
    ref::Texture out{"", 1 << t.log2_width, 1 << t.log2_height, {}};
    for (int n = 0; n < out.width * out.height; ++n) {
      if (memory_.find(t.base + n) == memory_.end()) return out;
    }
    for (int n = 0; n < out.width * out.height; ++n) out.texels.push_back(texel(t, n % out.width, n / out.width));
    return out;
  }
  // At a place, or the nearest.
  std::array<double, 3> interpolated(const model::RawTexture& t, const std::array<double, 2>& where) const {
    const std::int64_t i = std::int64_t(std::floor(where[0])), j = std::int64_t(std::floor(where[1]));
    const double a = is_bilinear(c_) ? where[0] - double(i) : 0, b = is_bilinear(c_) ? where[1] - double(j) : 0;
    std::array<double, 3> out;
    for (std::size_t c = 0; c < 3; ++c) {
      out[c] = (1 - b) * (1 - a) * texel(t, i, j)[c];
      if (a > 0) out[c] += (1 - b) * a * texel(t, i + 1, j)[c];
      if (b > 0) out[c] += b * (1 - a) * texel(t, i, j + 1)[c];
      if (a > 0 && b > 0) out[c] += b * a * texel(t, i + 1, j + 1)[c];
    }
    return out;
  }

  double full() const { return (1 << c_.colour_bits) - 1; }

  // Of a lit colour between two, and a texel between two: rounded, and `more` off before it is.
  ColourBox product(const ColourBox& lit, const std::array<double, 3>& low, const std::array<double, 3>& high,
                    double more) const {
    ColourBox out;
    for (std::size_t c = 0; c < 3; ++c) {
      out.low[c] = std::ceil(lit.low[c] * std::max(low[c], 0.0) / full() - 0.5 - more - kTinyShare);
      out.high[c] = std::floor(lit.high[c] * std::min(high[c], full()) / full() + 0.5 + more + kTinyShare);
    }
    return out;
  }

  ColourBound nearest(const model::RawTexture& t, const std::array<double, 2>& where,
                      const std::array<double, 2>& error, const ColourBound& lit) const {
    ColourBound out;
    for (std::int64_t j = first(where[1], error[1]); j <= last(where[1], error[1]); ++j) {
      for (std::int64_t i = first(where[0], error[0]); i <= last(where[0], error[0]); ++i) {
        const Rgb& rgb = texel(t, i, j);
        const std::array<double, 3> value{double(rgb[0]), double(rgb[1]), double(rgb[2])};
        for (const ColourBox& box : lit.boxes) out.boxes.push_back(product(box, value, value, 0));
      }
    }
    return out;
  }

  ColourBound bilinear(const model::RawTexture& t, const std::array<double, 2>& where,
                       const std::array<double, 2>& error, const std::array<double, 3>& exact,
                       const ColourBound& lit) const {
    ColourBound out;
    std::array<double, 3> low, high;
    for (std::size_t c = 0; c < 3; ++c) {
      // The filter is no steeper than two texels side by side differ.
      double steep_x = 0, steep_y = 0;
      for (std::int64_t y = first(where[1], error[1]); y <= last(where[1], error[1]) + 1; ++y) {
        for (std::int64_t x = first(where[0], error[0]); x <= last(where[0], error[0]) + 1; ++x) {
          const int here = texel(t, x, y)[c];
          if (x <= last(where[0], error[0]))
            steep_x = std::max(steep_x, double(std::abs(here - texel(t, x + 1, y)[c])));
          if (y <= last(where[1], error[1]))
            steep_y = std::max(steep_y, double(std::abs(here - texel(t, x, y + 1)[c])));
        }
      }
      const double off = error[0] * steep_x + error[1] * steep_y + std::ldexp(1.0, -kFilteredFraction - 1);
      low[c] = exact[c] - off, high[c] = exact[c] + off;
    }
    const double more = std::ldexp(1.0, -c_.colour_bits - 1) + std::ldexp(1.0, -c_.colour_bits - 8);
    for (const ColourBox& box : lit.boxes) out.boxes.push_back(product(box, low, high, more));
    return out;
  }

  static std::int64_t first(double at, double error) { return std::int64_t(std::floor(at - error)); }
  static std::int64_t last(double at, double error) { return std::int64_t(std::floor(at + error)); }

  const Config c_;
  const model::NamedFrame& frame_;
  std::unordered_map<int, Rgb> memory_;
  std::vector<ref::Texture> whole_;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_FORMATS_EXTREMES_TEXTURE_BOUND_HPP_
